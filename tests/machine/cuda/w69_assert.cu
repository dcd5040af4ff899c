// expect: plain,bounds,races,watch,order error 7 assert; maybe warning 10 leak
#include <cuda_runtime.h>
#include <cstdio>
#include <cstdlib>
#include <vector>
#include <cassert>
__global__ void k(int* b, int n) { assert(threadIdx.x < n); b[threadIdx.x] = 1; }  // BUG
int main() {
    int* b;
    cudaMalloc(&b, 64 * sizeof(int));
    k<<<1, 64>>>(b, 60);
    cudaError_t e = cudaDeviceSynchronize();
    printf("status: %s\n", cudaGetErrorString(e));
    return e != cudaSuccess;
}
