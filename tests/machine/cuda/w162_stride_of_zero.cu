// expect: plain,bounds,races,watch,order error 8|9 endless-loop
// The stride of the loop is a number of warps, which is 0 for a block of 16 threads.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void sum(const int* x, int n, int* out) {
    int total = 0;
    for (int i = threadIdx.x / 32; i < n; i += blockDim.x / 32)  // BUG: 16 / 32 is 0
        total += x[i];  // BUG
    atomicAdd(out, total);
}
int main() {
    const int n = 100;
    std::vector<int> h(n, 1);
    int *x, *out, result = 0;
    cudaMalloc(&x, n * sizeof(int));
    cudaMalloc(&out, sizeof(int));
    cudaMemcpy(x, h.data(), n * sizeof(int), cudaMemcpyHostToDevice);
    cudaMemset(out, 0, sizeof(int));
    sum<<<1, 16>>>(x, n, out);
    cudaMemcpy(&result, out, sizeof(int), cudaMemcpyDeviceToHost);
    printf("%d\n", result);
    cudaFree(x);
    cudaFree(out);
}
