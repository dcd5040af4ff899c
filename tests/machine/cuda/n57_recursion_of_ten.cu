// expect: nothing
// A recursion that is ten calls deep, with a stack that was made larger for it.
#include <cuda_runtime.h>
#include <cstdio>
__device__ int tree_sum(const int* x, int from, int count) {
    if (count == 1) return x[from];
    int half = count / 2;
    return tree_sum(x, from, half) + tree_sum(x, from + half, count - half);
}
__global__ void sum(const int* x, int n, int* out) { *out = tree_sum(x, 0, n); }
int main() {
    const int n = 1000;
    int *x, *out, h[n], result;
    for (int i = 0; i < n; ++i) h[i] = 1;
    cudaDeviceSetLimit(cudaLimitStackSize, 8192);
    cudaMalloc(&x, sizeof(h));
    cudaMalloc(&out, sizeof(int));
    cudaMemcpy(x, h, sizeof(h), cudaMemcpyHostToDevice);
    sum<<<1, 1>>>(x, n, out);
    cudaMemcpy(&result, out, sizeof(int), cudaMemcpyDeviceToHost);
    printf("%d\n", result);
    cudaFree(x);
    cudaFree(out);
    return result != n;
}
