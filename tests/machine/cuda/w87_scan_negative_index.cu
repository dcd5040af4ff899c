// expect: bounds,watch error 12 index-out-of-bounds
// An inclusive scan without the test that there is a left neighbour.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void scan(int* data) {
    __shared__ int s[2][64];
    int t = threadIdx.x, from = 0;
    s[0][t] = data[t];
    __syncthreads();
    for (int d = 1; d < 64; d *= 2) {
        s[1 - from][t] = s[from][t] + s[from][t - d];  // BUG: t may be less than d
        from = 1 - from;
        __syncthreads();
    }
    data[t] = s[from][t];
}
int main() {
    std::vector<int> h(64, 1);
    int* data;
    cudaMalloc(&data, 64 * sizeof(int));
    cudaMemcpy(data, h.data(), 64 * sizeof(int), cudaMemcpyHostToDevice);
    scan<<<1, 64>>>(data);
    cudaMemcpy(h.data(), data, 64 * sizeof(int), cudaMemcpyDeviceToHost);
    printf("%d\n", h[63]);
    cudaFree(data);
}
