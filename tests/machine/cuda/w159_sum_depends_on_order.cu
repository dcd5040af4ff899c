// expect: order warning 0 order-dependence
// Great numbers of both signs cancel: which small ones survive depends on the order of the atomics.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void sum(const float* x, int n, float* total) {
    int i = blockIdx.x * blockDim.x + threadIdx.x;
    if (i < n) atomicAdd(total, x[i]);
}
int main() {
    const int n = 256;
    std::vector<float> h(n, 1.f);
    h[20] = 1e8f;
    h[130] = -1e8f;
    float *x, *total, result;
    cudaMalloc(&x, n * sizeof(float));
    cudaMalloc(&total, sizeof(float));
    cudaMemcpy(x, h.data(), n * sizeof(float), cudaMemcpyHostToDevice);
    cudaMemset(total, 0, sizeof(float));
    sum<<<4, 64>>>(x, n, total);
    cudaMemcpy(&result, total, sizeof(float), cudaMemcpyDeviceToHost);
    printf("%g\n", result);
    cudaFree(x);
    cudaFree(total);
}
