// expect: order warning 0 order-dependence
// An atomic counter gives places in any order, but the result is printed as if it were sorted.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void keep_odd(const int* in, int n, int* out, int* count) {
    int i = blockIdx.x * blockDim.x + threadIdx.x;
    if (i < n && in[i] % 2) out[atomicAdd(count, 1)] = in[i];
}
int main() {
    const int n = 128;
    std::vector<int> h(n);
    for (int i = 0; i < n; ++i) h[i] = i;
    int *in, *out, *count, kept;
    cudaMalloc(&in, n * sizeof(int));
    cudaMalloc(&out, n * sizeof(int));
    cudaMalloc(&count, sizeof(int));
    cudaMemcpy(in, h.data(), n * sizeof(int), cudaMemcpyHostToDevice);
    cudaMemset(count, 0, sizeof(int));
    keep_odd<<<2, 64>>>(in, n, out, count);
    cudaMemcpy(&kept, count, sizeof(int), cudaMemcpyDeviceToHost);
    cudaMemcpy(h.data(), out, kept * sizeof(int), cudaMemcpyDeviceToHost);
    printf("the first three: %d %d %d\n", h[0], h[1], h[2]);
    cudaFree(in);
    cudaFree(out);
    cudaFree(count);
}
