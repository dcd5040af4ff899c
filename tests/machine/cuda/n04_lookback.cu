// expect: nothing (yet race)
#include <cuda_runtime.h>
#include <cstdio>
#include <cstdlib>
#include <vector>
__device__ unsigned next_block;
__device__ volatile int flags[8];
__device__ volatile float sums[8];
__global__ void k(const float* a, float* b) {
    __shared__ unsigned id;
    __shared__ float s[32], before;
    int t = threadIdx.x;
    if (t == 0) id = atomicAdd(&next_block, 1);
    __syncthreads();
    s[t] = a[id * 32 + t];
    __syncthreads();
    if (t == 0) {
        float sum = 0, prev = 0;
        for (int i = 0; i < 32; ++i) sum += s[i];
        if (id > 0) {
            while (flags[id - 1] == 0) { }
            __threadfence();
            prev = sums[id - 1];
        }
        sums[id] = prev + sum;
        __threadfence();
        flags[id] = 1;
        before = prev;
    }
    __syncthreads();
    b[id * 32 + t] = before + s[t];
}
int main() {
    const int n = 256;
    std::vector<float> h(n);
    for (int i = 0; i < n; ++i) h[i] = i % 7;
    float *a, *b;
    cudaMalloc(&a, n * sizeof(float));
    cudaMalloc(&b, n * sizeof(float));
    cudaMemcpy(a, h.data(), n * sizeof(float), cudaMemcpyHostToDevice);
    cudaMemset(b, 0, n * sizeof(float));
    k<<<8, 32>>>(a, b);
    cudaMemcpy(h.data(), b, n * sizeof(float), cudaMemcpyDeviceToHost);
    printf("%g %g\n", h[0], h[n - 1]);
    cudaFree(a);
    cudaFree(b);
    cudaError_t e = cudaDeviceSynchronize();
    printf("status: %s\n", cudaGetErrorString(e));
    return e != cudaSuccess;
}
