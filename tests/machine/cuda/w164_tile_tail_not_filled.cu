// expect: watch error 12|15 uninitialised-shared
// The tail of the last tile is not loaded, but it is added.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void sum(const float* in, float* out, int n) {
    __shared__ float s[64];
    int t = threadIdx.x, i = blockIdx.x * 64 + t;
    if (i < n) s[t] = in[i];
    __syncthreads();
    for (int d = 32; d > 0; d /= 2) {
        if (t < d) s[t] += s[t + d];  // BUG: s[t] = 0 is missing where i >= n
        __syncthreads();
    }
    if (t == 0) out[blockIdx.x] = s[0];  // BUG
}
int main() {
    const int n = 100;
    std::vector<float> h(n, 1.f);
    float *in, *out;
    cudaMalloc(&in, n * sizeof(float));
    cudaMalloc(&out, 2 * sizeof(float));
    cudaMemcpy(in, h.data(), n * sizeof(float), cudaMemcpyHostToDevice);
    sum<<<2, 64>>>(in, out, n);
    cudaMemcpy(h.data(), out, 2 * sizeof(float), cudaMemcpyDeviceToHost);
    printf("%g\n", h[0]);
    cudaFree(in);
    cudaFree(out);
}
