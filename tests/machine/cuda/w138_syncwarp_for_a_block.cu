// expect: races,watch error 9|11 race
// __syncwarp() orders one warp; the reversed index goes to the other.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void reverse(int* x) {
    __shared__ int s[64];
    int t = threadIdx.x;
    s[t] = x[t];  // BUG
    __syncwarp();
    x[t] = s[63 - t];  // BUG: written by another warp
}
int main() {
    std::vector<int> h(64);
    for (int i = 0; i < 64; ++i) h[i] = i;
    int* x;
    cudaMalloc(&x, 64 * sizeof(int));
    cudaMemcpy(x, h.data(), 64 * sizeof(int), cudaMemcpyHostToDevice);
    reverse<<<1, 64>>>(x);
    cudaMemcpy(h.data(), x, 64 * sizeof(int), cudaMemcpyDeviceToHost);
    printf("done\n");
    cudaFree(x);
}
