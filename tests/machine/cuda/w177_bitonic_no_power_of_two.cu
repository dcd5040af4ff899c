// expect: bounds,watch error 15|17|18 index-out-of-bounds
// Bitonic sort of a length that is no power of two: the partner may lie beyond the end.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
#define N 48
__global__ void sort(int* x) {
    __shared__ int s[N];
    int t = threadIdx.x;
    s[t] = x[t];
    __syncthreads();
    for (int k = 2; k <= 64; k *= 2)
        for (int j = k / 2; j > 0; j /= 2) {
            int partner = t ^ j;
            if (partner > t && ((t & k) == 0) == (s[t] > s[partner])) {  // BUG: partner may be 48 or more
                int a = s[t];
                s[t] = s[partner];  // BUG
                s[partner] = a;  // BUG
            }
            __syncthreads();
        }
    x[t] = s[t];
}
int main() {
    std::vector<int> h(N);
    for (int i = 0; i < N; ++i) h[i] = (i * 31) % N;
    int* x;
    cudaMalloc(&x, N * sizeof(int));
    cudaMemcpy(x, h.data(), N * sizeof(int), cudaMemcpyHostToDevice);
    sort<<<1, N>>>(x);
    cudaMemcpy(h.data(), x, N * sizeof(int), cudaMemcpyDeviceToHost);
    printf("done\n");
    cudaFree(x);
}
