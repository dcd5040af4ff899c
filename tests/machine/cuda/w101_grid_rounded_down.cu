// expect: watch error 12 uninitialised-global
// n / block blocks leave the tail unwritten, and the next kernel reads it.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void squares(float* x, int n) {
    int i = blockIdx.x * blockDim.x + threadIdx.x;
    if (i < n) x[i] = i * i;
}
__global__ void roots(const float* x, float* y, int n) {
    int i = blockIdx.x * blockDim.x + threadIdx.x;
    if (i < n) y[i] = sqrtf(x[i]);  // BUG: the last elements of x were never written
}
int main() {
    const int n = 1000, block = 128;
    float *x, *y;
    cudaMalloc(&x, n * sizeof(float));
    cudaMalloc(&y, n * sizeof(float));
    squares<<<n / block, block>>>(x, n);
    roots<<<(n + block - 1) / block, block>>>(x, y, n);
    std::vector<float> h(n);
    cudaMemcpy(h.data(), y, n * sizeof(float), cudaMemcpyDeviceToHost);
    printf("%g\n", h[10]);
    cudaFree(x);
    cudaFree(y);
}
