// expect: nothing
// __syncthreads_or() lets all threads of a block leave the loop together.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void odd_even_sort(int* x) {
    __shared__ int s[64];
    int t = threadIdx.x, swapped;
    s[t] = x[t];
    __syncthreads();
    do {
        swapped = 0;
        for (int odd = 0; odd < 2; ++odd) {
            int i = 2 * t + odd;
            if (i + 1 < 64 && s[i] > s[i + 1]) {
                int a = s[i];
                s[i] = s[i + 1];
                s[i + 1] = a;
                swapped = 1;
            }
            __syncthreads();
        }
    } while (__syncthreads_or(swapped));
    x[t] = s[t];
}
int main() {
    std::vector<int> h(64);
    for (int i = 0; i < 64; ++i) h[i] = (i * 27) % 64;
    int* x;
    cudaMalloc(&x, 64 * sizeof(int));
    cudaMemcpy(x, h.data(), 64 * sizeof(int), cudaMemcpyHostToDevice);
    odd_even_sort<<<1, 64>>>(x);
    cudaMemcpy(h.data(), x, 64 * sizeof(int), cudaMemcpyDeviceToHost);
    printf("%d %d\n", h[0], h[63]);
    cudaFree(x);
    return h[0] != 0 || h[63] != 63;
}
