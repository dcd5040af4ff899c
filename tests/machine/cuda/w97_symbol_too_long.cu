// expect: plain,bounds,races,watch,order error 20 bad-copy
// More is copied to a symbol than it has room for.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__constant__ float coefficients[8];
__global__ void polynomial(float* x, int n) {
    int i = blockIdx.x * blockDim.x + threadIdx.x;
    if (i >= n) return;
    float y = 0;
    for (int k = 7; k >= 0; --k) y = y * x[i] + coefficients[k];
    x[i] = y;
}
int main() {
    const int n = 128;
    std::vector<float> h(n, 0.5f), c(16, 1.f);
    float* x;
    cudaMalloc(&x, n * sizeof(float));
    cudaMemcpy(x, h.data(), n * sizeof(float), cudaMemcpyHostToDevice);
    cudaMemcpyToSymbol(coefficients, c.data(), c.size() * sizeof(float));  // BUG: 16, not 8
    polynomial<<<1, n>>>(x, n);
    cudaMemcpy(h.data(), x, n * sizeof(float), cudaMemcpyDeviceToHost);
    printf("%g\n", h[0]);
    cudaFree(x);
}
