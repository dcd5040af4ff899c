// expect: compile error 10 does-not-compile
#include <cuda_runtime.h>
#include <cstdio>
#include <cstdlib>
#include <vector>
__global__ void k(std::vector<float> v, float* b) { b[threadIdx.x] = v[threadIdx.x]; }  // BUG
int main() {
    float* b; std::vector<float> v(64);
    cudaMalloc(&b, 64 * sizeof(float));
    k<<<1, 64>>>(v, b);  // BUG
    cudaError_t e = cudaDeviceSynchronize();
    printf("status: %s\n", cudaGetErrorString(e));
    return e != cudaSuccess;
}
