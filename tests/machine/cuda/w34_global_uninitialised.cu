// expect: watch error 6|7|8 uninitialised-global
#include <cuda_runtime.h>
#include <cstdio>
#include <cstdlib>
#include <vector>
__global__ void k(float* b) { b[threadIdx.x] += 1; }
int main() {
    float* b; float h[64];
    cudaMalloc(&b, sizeof(h));
    k<<<1, 64>>>(b);  // BUG
    cudaMemcpy(h, b, sizeof(h), cudaMemcpyDeviceToHost);
    printf("%g\n", h[5]);
    cudaFree(b);
    cudaError_t e = cudaDeviceSynchronize();
    printf("status: %s\n", cudaGetErrorString(e));
    return e != cudaSuccess;
}
