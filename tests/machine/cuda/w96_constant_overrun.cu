// expect: bounds,watch error 14 index-out-of-bounds
// Weights of a convolution in constant memory, read with a radius that is one too large.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
#define RADIUS 3
__constant__ float weights[2 * RADIUS + 1];
__global__ void convolve(const float* in, float* out, int n) {
    int i = blockIdx.x * blockDim.x + threadIdx.x;
    if (i >= n) return;
    float sum = 0;
    for (int k = 0; k <= 2 * RADIUS + 1; ++k) {
        int j = min(max(i + k - RADIUS, 0), n - 1);
        sum += weights[k] * in[j];  // BUG: k == 2 * RADIUS + 1
    }
    out[i] = sum;
}
int main() {
    const int n = 200;
    std::vector<float> h(n, 1.f), w(2 * RADIUS + 1, 1.f / 7);
    float *in, *out;
    cudaMalloc(&in, n * sizeof(float));
    cudaMalloc(&out, n * sizeof(float));
    cudaMemcpy(in, h.data(), n * sizeof(float), cudaMemcpyHostToDevice);
    cudaMemcpyToSymbol(weights, w.data(), w.size() * sizeof(float));
    convolve<<<(n + 63) / 64, 64>>>(in, out, n);
    cudaMemcpy(h.data(), out, n * sizeof(float), cudaMemcpyDeviceToHost);
    printf("%d\n", int(h[0]));
    cudaFree(in);
    cudaFree(out);
}
