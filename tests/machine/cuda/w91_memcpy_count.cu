// expect: watch error 8 uninitialised-global
// cudaMemcpy() is given the number of elements, not of bytes: a quarter arrives.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void squares(const int* in, int* out, int n) {
    int i = blockIdx.x * blockDim.x + threadIdx.x;
    if (i < n) out[i] = in[i] * in[i];  // BUG: most of in was never written
}
int main() {
    const int n = 1024;
    std::vector<int> h(n);
    for (int i = 0; i < n; ++i) h[i] = i;
    int *in, *out;
    cudaMalloc(&in, n * sizeof(int));
    cudaMalloc(&out, n * sizeof(int));
    cudaMemcpy(in, h.data(), n, cudaMemcpyHostToDevice);
    squares<<<n / 256, 256>>>(in, out, n);
    cudaMemcpy(h.data(), out, n * sizeof(int), cudaMemcpyDeviceToHost);
    printf("%d\n", h[2]);
    cudaFree(in);
    cudaFree(out);
}
