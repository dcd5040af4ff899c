// expect: races,watch error 8|14 race
// The second call overwrites the shared array while slow threads still read the first result.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__device__ float block_sum(float value) {
    __shared__ float s[64];
    s[threadIdx.x] = value;  // BUG: a barrier is missing before this line
    __syncthreads();
    for (int d = 32; d > 0; d /= 2) {
        if (threadIdx.x < d) s[threadIdx.x] += s[threadIdx.x + d];
        __syncthreads();
    }
    return s[0];  // BUG
}
__global__ void variance(const float* x, float* out) {
    float value = x[blockIdx.x * 64 + threadIdx.x];
    float mean = block_sum(value) / 64;
    float square = block_sum((value - mean) * (value - mean));
    if (threadIdx.x == 0) out[blockIdx.x] = square / 64;
}
int main() {
    std::vector<float> h(128);
    for (int i = 0; i < 128; ++i) h[i] = i % 2;
    float *x, *out;
    cudaMalloc(&x, 128 * sizeof(float));
    cudaMalloc(&out, 2 * sizeof(float));
    cudaMemcpy(x, h.data(), 128 * sizeof(float), cudaMemcpyHostToDevice);
    variance<<<2, 64>>>(x, out);
    cudaMemcpy(h.data(), out, 2 * sizeof(float), cudaMemcpyDeviceToHost);
    printf("%d\n", h[0] >= 0);
    cudaFree(x);
    cudaFree(out);
}
