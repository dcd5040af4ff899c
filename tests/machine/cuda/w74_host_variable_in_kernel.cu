// expect: host error 7 host-variable
#include <cuda_runtime.h>
#include <cstdio>
#include <cstdlib>
#include <vector>
float factor = 3;
__global__ void k(const float* a, float* b) { b[threadIdx.x] = factor * a[threadIdx.x]; }  // BUG
int main() {
    const int n = 256;
    std::vector<float> h(n);
    for (int i = 0; i < n; ++i) h[i] = i % 7;
    float *a, *b;
    cudaMalloc(&a, n * sizeof(float));
    cudaMalloc(&b, n * sizeof(float));
    cudaMemcpy(a, h.data(), n * sizeof(float), cudaMemcpyHostToDevice);
    cudaMemset(b, 0, n * sizeof(float));
    k<<<1, 64>>>(a, b);
    cudaMemcpy(h.data(), b, n * sizeof(float), cudaMemcpyDeviceToHost);
    printf("%g %g\n", h[0], h[n - 1]);
    cudaFree(a);
    cudaFree(b);
    cudaError_t e = cudaDeviceSynchronize();
    printf("status: %s\n", cudaGetErrorString(e));
    return e != cudaSuccess;
}
