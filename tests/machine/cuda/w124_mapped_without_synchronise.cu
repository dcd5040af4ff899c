// expect: watch error 18 race|unsynchronised
// A counter in mapped host memory is read before the kernel is known to have ended.
#include <cuda_runtime.h>
#include <cstdio>
__global__ void count(const int* x, int n, int* even) {
    int i = blockIdx.x * blockDim.x + threadIdx.x;
    if (i < n && x[i] % 2 == 0) atomicAdd(even, 1);
}
int main() {
    const int n = 128;
    int *x, *even, *d_even;
    cudaMalloc(&x, n * sizeof(int));
    cudaMemset(x, 0, n * sizeof(int));
    cudaHostAlloc((void**)&even, sizeof(int), cudaHostAllocMapped);
    *even = 0;
    cudaHostGetDevicePointer((void**)&d_even, even, 0);
    count<<<1, n>>>(x, n, d_even);
    printf("%d\n", *even);  // BUG: no cudaDeviceSynchronize()
    cudaFree(x);
    cudaFreeHost(even);
}
