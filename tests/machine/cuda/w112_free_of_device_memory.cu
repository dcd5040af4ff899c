// expect: plain,bounds,races,watch,order error 18 bad-free|host-crash|abort
// free() is given what cudaMalloc() gave.
#include <cuda_runtime.h>
#include <cstdio>
#include <cstdlib>
__global__ void iota(int* x, int n) {
    int i = blockIdx.x * blockDim.x + threadIdx.x;
    if (i < n) x[i] = i;
}
int main() {
    const int n = 100;
    int *h = (int*)malloc(n * sizeof(int)), *d;
    cudaMalloc(&d, n * sizeof(int));
    iota<<<1, 128>>>(d, n);
    cudaMemcpy(h, d, n * sizeof(int), cudaMemcpyDeviceToHost);
    printf("%d\n", h[99]);
    fflush(stdout);
    free(d);  // BUG
    free(h);
}
