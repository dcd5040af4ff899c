// expect: watch error 6 uninitialised-global
#include <cuda_runtime.h>
#include <cstdio>
#include <cstdlib>
#include <vector>
__global__ void k(const float* a, float* b) { b[threadIdx.x] = 2 * a[threadIdx.x]; }
int main() {
    float* h = (float*)malloc(64 * sizeof(float)); float *a, *b;
    for (int i = 0; i < 64; ++i) h[i] = 1;
    cudaMalloc(&a, 64 * sizeof(float)); cudaMalloc(&b, 64 * sizeof(float));
    cudaMemcpy(a, h, sizeof(h), cudaMemcpyHostToDevice);  // BUG
    k<<<1, 64>>>(a, b);
    cudaMemcpy(h, b, 64 * sizeof(float), cudaMemcpyDeviceToHost);
    printf("%g\n", h[63]);
    cudaFree(a); cudaFree(b); free(h);
    cudaError_t e = cudaDeviceSynchronize();
    printf("status: %s\n", cudaGetErrorString(e));
    return e != cudaSuccess;
}
