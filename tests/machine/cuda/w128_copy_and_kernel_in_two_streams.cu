// expect: watch error 5|15 race|unsynchronised
// The copy goes through one stream, the kernel that needs it through another.
#include <cuda_runtime.h>
#include <cstdio>
__global__ void square(int* x) { x[threadIdx.x] *= x[threadIdx.x]; }  // BUG
int main() {
    const int n = 96;
    int *h, *x;
    cudaMallocHost((void**)&h, n * sizeof(int));
    cudaMalloc(&x, n * sizeof(int));
    for (int i = 0; i < n; ++i) h[i] = i;
    cudaStream_t copies, kernels;
    cudaStreamCreate(&copies);
    cudaStreamCreate(&kernels);
    cudaMemcpyAsync(x, h, n * sizeof(int), cudaMemcpyHostToDevice, copies);  // BUG: no event
    square<<<1, n, 0, kernels>>>(x);
    cudaDeviceSynchronize();
    cudaMemcpy(h, x, n * sizeof(int), cudaMemcpyDeviceToHost);
    printf("%d\n", h[5]);
    cudaStreamDestroy(copies);
    cudaStreamDestroy(kernels);
    cudaFreeHost(h);
    cudaFree(x);
}
