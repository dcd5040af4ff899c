// expect: plain,bounds,races,watch,order error 8 assert
// An assertion about the input, in a function that the kernel calls.
#include <cuda_runtime.h>
#include <cassert>
#include <cstdio>
#include <vector>
__device__ float inverse(float x) {
    assert(x != 0);  // BUG: one input is 0
    return 1 / x;
}
__global__ void invert(float* x, int n) {
    int i = blockIdx.x * blockDim.x + threadIdx.x;
    if (i < n) x[i] = inverse(x[i]);
}
int main() {
    const int n = 100;
    std::vector<float> h(n);
    for (int i = 0; i < n; ++i) h[i] = i - 70;
    float* x;
    cudaMalloc(&x, n * sizeof(float));
    cudaMemcpy(x, h.data(), n * sizeof(float), cudaMemcpyHostToDevice);
    invert<<<1, 128>>>(x, n);
    cudaError_t e = cudaDeviceSynchronize();
    printf("%s\n", cudaGetErrorString(e));
    cudaFree(x);
}
