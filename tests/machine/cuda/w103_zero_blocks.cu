// expect: plain,bounds,races,watch,order error 16 bad-launch
// n / block is 0 for a small n, and nobody looks at the error.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void increment(int* x, int n) {
    int i = blockIdx.x * blockDim.x + threadIdx.x;
    if (i < n) ++x[i];
}
int main() {
    const int n = 100, block = 256;
    std::vector<int> h(n, 1);
    int* x;
    cudaMalloc(&x, n * sizeof(int));
    cudaMemcpy(x, h.data(), n * sizeof(int), cudaMemcpyHostToDevice);
    increment<<<n / block, block>>>(x, n);  // BUG: 0 blocks
    cudaMemcpy(h.data(), x, n * sizeof(int), cudaMemcpyDeviceToHost);
    printf("%d\n", h[0]);
    cudaFree(x);
}
