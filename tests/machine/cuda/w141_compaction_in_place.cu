// expect: races,watch error 9|10 race
// The kept elements are written to the front of the array that other threads still read.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void keep_positive(int* x, int n, int* count) {
    int i = blockIdx.x * blockDim.x + threadIdx.x;
    if (i >= n) return;
    int value = x[i];  // BUG
    if (value > 0) x[atomicAdd(count, 1)] = value;  // BUG: this place may not have been read yet
}
int main() {
    const int n = 200;
    std::vector<int> h(n);
    for (int i = 0; i < n; ++i) h[i] = i % 3 - 1;
    int *x, *count, kept;
    cudaMalloc(&x, n * sizeof(int));
    cudaMalloc(&count, sizeof(int));
    cudaMemset(count, 0, sizeof(int));
    cudaMemcpy(x, h.data(), n * sizeof(int), cudaMemcpyHostToDevice);
    keep_positive<<<2, 128>>>(x, n, count);
    cudaMemcpy(&kept, count, sizeof(int), cudaMemcpyDeviceToHost);
    printf("%d\n", kept > 0);
    cudaFree(x);
    cudaFree(count);
}
