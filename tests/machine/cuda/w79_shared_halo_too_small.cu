// expect: bounds,watch error 12 index-out-of-bounds
// A tile with a halo of one on each side, for which the array is one element too short.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
#define TILE 64
__global__ void difference(const float* in, float* out, int n) {
    __shared__ float s[TILE + 1];
    int t = threadIdx.x, i = blockIdx.x * TILE + t;
    s[t + 1] = i < n ? in[i] : 0;
    if (t == 0) s[0] = i > 0 ? in[i - 1] : 0;
    if (t == TILE - 1) s[t + 2] = i + 1 < n ? in[i + 1] : 0;  // BUG: s has TILE + 1 elements
    __syncthreads();
    if (i < n) out[i] = t + 2 < TILE + 1 ? s[t + 2] - s[t] : 0;
}
int main() {
    const int n = 256;
    std::vector<float> h(n);
    for (int i = 0; i < n; ++i) h[i] = i * i;
    float *in, *out;
    cudaMalloc(&in, n * sizeof(float));
    cudaMalloc(&out, n * sizeof(float));
    cudaMemcpy(in, h.data(), n * sizeof(float), cudaMemcpyHostToDevice);
    difference<<<n / TILE, TILE>>>(in, out, n);
    cudaMemcpy(h.data(), out, n * sizeof(float), cudaMemcpyDeviceToHost);
    printf("%g\n", h[5]);
    cudaFree(in);
    cudaFree(out);
}
