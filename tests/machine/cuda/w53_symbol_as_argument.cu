// expect: plain,bounds,races,watch,order error 11 host-pointer
#include <cuda_runtime.h>
#include <cstdio>
#include <cstdlib>
#include <vector>
__device__ float table[64];
__global__ void k(const float* a, float* b) { b[threadIdx.x] = a[threadIdx.x]; }
int main() {
    float* b;
    cudaMalloc(&b, 64 * sizeof(float));
    k<<<1, 64>>>(table, b);  // BUG
    cudaFree(b);
    cudaError_t e = cudaDeviceSynchronize();
    printf("status: %s\n", cudaGetErrorString(e));
    return e != cudaSuccess;
}
