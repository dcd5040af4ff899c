// expect: plain,bounds,races,watch,order error 19 bad-copy
// cudaMemcpy() instead of cudaMemcpyToSymbol(): the name is an address of the host.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__constant__ float palette[16];
__global__ void color(const int* index, float* out, int n) {
    int i = blockIdx.x * blockDim.x + threadIdx.x;
    if (i < n) out[i] = palette[index[i] % 16];
}
int main() {
    const int n = 64;
    std::vector<float> colors(16, 0.5f), h(n);
    int* index;
    float* out;
    cudaMalloc(&index, n * sizeof(int));
    cudaMalloc(&out, n * sizeof(float));
    cudaMemset(index, 0, n * sizeof(int));
    cudaMemcpy(palette, colors.data(), 16 * sizeof(float), cudaMemcpyHostToDevice);  // BUG
    color<<<1, n>>>(index, out, n);
    cudaMemcpy(h.data(), out, n * sizeof(float), cudaMemcpyDeviceToHost);
    printf("%g\n", h[0]);
    cudaFree(index);
    cudaFree(out);
}
