// expect: bounds error 11 out-of-bounds|shared-overrun|index-out-of-bounds; none error 11 shared-overrun
// As with a histogram in global memory, but the bins are in shared memory.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void histogram(const int* values, int* bins, int n) {
    __shared__ int local[16];
    if (threadIdx.x < 16) local[threadIdx.x] = 0;
    __syncthreads();
    int i = blockIdx.x * blockDim.x + threadIdx.x;
    if (i < n) atomicAdd(&local[values[i] / 16], 1);  // BUG: 256 / 16 == 16
    __syncthreads();
    if (threadIdx.x < 16) atomicAdd(&bins[threadIdx.x], local[threadIdx.x]);
}
int main() {
    const int n = 400;
    std::vector<int> h(n);
    for (int i = 0; i < n; ++i) h[i] = i % 257;
    int *values, *bins;
    cudaMalloc(&values, n * sizeof(int));
    cudaMalloc(&bins, 16 * sizeof(int));
    cudaMemcpy(values, h.data(), n * sizeof(int), cudaMemcpyHostToDevice);
    cudaMemset(bins, 0, 16 * sizeof(int));
    histogram<<<(n + 127) / 128, 128>>>(values, bins, n);
    cudaMemcpy(h.data(), bins, 16 * sizeof(int), cudaMemcpyDeviceToHost);
    printf("%d\n", h[0]);
    cudaFree(values);
    cudaFree(bins);
}
