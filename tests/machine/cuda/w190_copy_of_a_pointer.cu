// expect: plain,bounds,races,watch,order error 18 bad-copy
// The address of the pointer is copied to the device instead of what it points to.
#include <cuda_runtime.h>
#include <cstdio>
#include <cstdlib>
__global__ void sum(const int* x, int n, int* out) {
    int total = 0;
    for (int i = 0; i < n; ++i) total += x[i];
    *out = total;
}
int main() {
    const int n = 32;
    int *h = (int*)malloc(n * sizeof(int)), *x, *out, result = 0;
    for (int i = 0; i < n; ++i) h[i] = i;
    cudaMalloc(&x, n * sizeof(int));
    cudaMalloc(&out, sizeof(int));
    cudaMemset(x, 0, n * sizeof(int));
    cudaMemcpy(&x, h, n * sizeof(int), cudaMemcpyHostToDevice);  // BUG: x, not &x
    sum<<<1, 1>>>(x, n, out);
    cudaMemcpy(&result, out, sizeof(int), cudaMemcpyDeviceToHost);
    printf("%d\n", result);
    cudaFree(out);
    cudaFree(x);
    free(h);
}
