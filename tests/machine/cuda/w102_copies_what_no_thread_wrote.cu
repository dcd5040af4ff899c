// expect: watch note 20 uninitialised-global|uninitialised-copy
// n / block blocks leave the tail unwritten, and the host copies all of it.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void axpy(float a, const float* x, const float* y, float* out, int n) {
    int i = blockIdx.x * blockDim.x + threadIdx.x;
    if (i < n) out[i] = a * x[i] + y[i];
}
int main() {
    const int n = 1000, block = 256;
    std::vector<float> h(n, 1.f);
    float *x, *y, *out;
    cudaMalloc(&x, n * sizeof(float));
    cudaMalloc(&y, n * sizeof(float));
    cudaMalloc(&out, n * sizeof(float));
    cudaMemcpy(x, h.data(), n * sizeof(float), cudaMemcpyHostToDevice);
    cudaMemcpy(y, h.data(), n * sizeof(float), cudaMemcpyHostToDevice);
    axpy<<<n / block, block>>>(2.f, x, y, out, n);
    cudaMemcpy(h.data(), out, n * sizeof(float), cudaMemcpyDeviceToHost);  // BUG: 232 unwritten
    printf("%g\n", h[0]);
    cudaFree(x);
    cudaFree(y);
    cudaFree(out);
}
