// expect: races,watch error 13 race
// Each block counts in shared memory with atomics, then adds to the result without.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void histogram(const int* x, int n, int* bins) {
    __shared__ int local[8];
    if (threadIdx.x < 8) local[threadIdx.x] = 0;
    __syncthreads();
    for (int i = blockIdx.x * blockDim.x + threadIdx.x; i < n; i += gridDim.x * blockDim.x)
        atomicAdd(&local[x[i] % 8], 1);
    __syncthreads();
    if (threadIdx.x < 8) bins[threadIdx.x] += local[threadIdx.x];  // BUG: so do other blocks
}
int main() {
    const int n = 300;
    std::vector<int> h(n);
    for (int i = 0; i < n; ++i) h[i] = i;
    int *x, *bins;
    cudaMalloc(&x, n * sizeof(int));
    cudaMalloc(&bins, 8 * sizeof(int));
    cudaMemcpy(x, h.data(), n * sizeof(int), cudaMemcpyHostToDevice);
    cudaMemset(bins, 0, 8 * sizeof(int));
    histogram<<<3, 32>>>(x, n, bins);
    cudaMemcpy(h.data(), bins, 8 * sizeof(int), cudaMemcpyDeviceToHost);
    printf("%d\n", h[0] > 0);
    cudaFree(x);
    cudaFree(bins);
}
