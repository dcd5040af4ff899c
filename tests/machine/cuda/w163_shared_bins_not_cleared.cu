// expect: watch error 9 uninitialised-shared
// A histogram in shared memory that does not start at 0.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void histogram(const unsigned char* text, int n, unsigned* bins) {
    __shared__ unsigned local[32];
    for (int i = blockIdx.x * blockDim.x + threadIdx.x; i < n; i += gridDim.x * blockDim.x)
        atomicAdd(&local[text[i] % 32], 1u);  // BUG: local was never set to 0
    __syncthreads();
    if (threadIdx.x < 32) atomicAdd(&bins[threadIdx.x], local[threadIdx.x]);
}
int main() {
    const int n = 320;
    std::vector<unsigned char> h(n);
    for (int i = 0; i < n; ++i) h[i] = i;
    unsigned char* text;
    unsigned* bins;
    cudaMalloc(&text, n);
    cudaMalloc(&bins, 32 * sizeof(unsigned));
    cudaMemcpy(text, h.data(), n, cudaMemcpyHostToDevice);
    cudaMemset(bins, 0, 32 * sizeof(unsigned));
    histogram<<<2, 64>>>(text, n, bins);
    unsigned first;
    cudaMemcpy(&first, bins, sizeof(unsigned), cudaMemcpyDeviceToHost);
    printf("done\n");
    cudaFree(text);
    cudaFree(bins);
}
