// expect: watch error 15 race|unsynchronised
// The host reads managed memory while the kernel may still write it.
#include <cuda_runtime.h>
#include <cstdio>
__global__ void iota(int* x, int n) {
    int i = blockIdx.x * blockDim.x + threadIdx.x;
    if (i < n) x[i] = i;
}
int main() {
    const int n = 256;
    int* x;
    cudaMallocManaged(&x, n * sizeof(int));
    iota<<<2, 128>>>(x, n);
    int sum = 0;
    for (int i = 0; i < n; ++i) sum += x[i];  // BUG: cudaDeviceSynchronize() comes too late
    cudaDeviceSynchronize();
    printf("%d\n", sum);
    cudaFree(x);
}
