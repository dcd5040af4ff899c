// expect: bounds,watch error 16 host-dereference|host-reads-device
// The result is printed from device memory.
#include <cuda_runtime.h>
#include <cstdio>
__global__ void powers(int* x, int n) {
    int i = threadIdx.x;
    if (i < n) x[i] = 1 << i;
}
int main() {
    const int n = 16;
    int* x;
    cudaMalloc(&x, n * sizeof(int));
    powers<<<1, 32>>>(x, n);
    cudaDeviceSynchronize();
    int sum = 0;
    for (int i = 0; i < n; ++i) sum += x[i];  // BUG: x is a device pointer
    printf("%d\n", sum);
    cudaFree(x);
}
