// expect: plain,bounds,races,watch,order error 9 out-of-memory; plain,bounds,races,watch,order error 6 null-pointer
#include <cuda_runtime.h>
#include <cstdio>
#include <cstdlib>
#include <vector>
__global__ void k(float* b) { b[threadIdx.x] = 1; }
int main() {
    float* b = nullptr;
    cudaMalloc(&b, size_t(1) << 50);  // BUG
    k<<<1, 32>>>(b);  // BUG
    cudaError_t e = cudaDeviceSynchronize();
    printf("status: %s\n", cudaGetErrorString(e));
    return e != cudaSuccess;
}
