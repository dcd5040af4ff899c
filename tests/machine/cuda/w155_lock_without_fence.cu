// expect: watch error 11 race
// The lock is right, but no fence stands between it and what it protects.
#include <cuda_runtime.h>
#include <cstdio>
__device__ int lock_word;
__global__ void extremes(const float* x, float* least, int n) {
    if (threadIdx.x != 0) return;
    float mine = x[blockIdx.x];
    while (atomicCAS(&lock_word, 0, 1) != 0) {
    }
    if (mine < *least) *least = mine;  // BUG: __threadfence() is missing before and behind it
    atomicExch(&lock_word, 0);
}
int main() {
    float h[8] = {5, 3, 8, 1, 9, 2, 7, 4}, *x, *least, result = 100;
    cudaMalloc(&x, sizeof(h));
    cudaMalloc(&least, sizeof(float));
    cudaMemcpy(x, h, sizeof(h), cudaMemcpyHostToDevice);
    cudaMemcpy(least, &result, sizeof(float), cudaMemcpyHostToDevice);
    extremes<<<8, 32>>>(x, least, 8);
    cudaMemcpy(&result, least, sizeof(float), cudaMemcpyDeviceToHost);
    printf("%g\n", result);
    cudaFree(x);
    cudaFree(least);
}
