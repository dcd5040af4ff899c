// expect: bounds,watch error 10 out-of-bounds
// A sum that adds two elements while it loads, for a length that is no multiple of two blocks.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void sum(const float* in, float* out, int n) {
    __shared__ float s[128];
    const unsigned t = threadIdx.x, i = blockIdx.x * 256 + t;
    s[t] = i < n ? in[i] : 0;
    s[t] += in[i + 128];  // BUG: i + 128 may be n or more
    __syncthreads();
    for (unsigned d = 64; d > 0; d /= 2) {
        if (t < d) s[t] += s[t + d];
        __syncthreads();
    }
    if (t == 0) out[blockIdx.x] = s[0];
}
int main() {
    const int n = 1000, blocks = (n + 255) / 256;
    std::vector<float> h(n, 1.f), sums(blocks);
    float *in, *out;
    cudaMalloc(&in, n * sizeof(float));
    cudaMalloc(&out, blocks * sizeof(float));
    cudaMemcpy(in, h.data(), n * sizeof(float), cudaMemcpyHostToDevice);
    sum<<<blocks, 128>>>(in, out, n);
    cudaMemcpy(sums.data(), out, blocks * sizeof(float), cudaMemcpyDeviceToHost);
    printf("%g\n", sums[0]);
    cudaFree(in);
    cudaFree(out);
}
