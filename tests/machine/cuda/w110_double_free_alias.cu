// expect: plain,bounds,races,watch,order error 30 bad-free
// After a swap of two buffers an odd number of times, one is freed twice and one never.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void heat(const float* in, float* out, int n) {
    int i = blockIdx.x * blockDim.x + threadIdx.x;
    if (i >= n) return;
    float left = in[max(i - 1, 0)], right = in[min(i + 1, n - 1)];
    out[i] = in[i] + 0.25f * (left - 2 * in[i] + right);
}
int main() {
    const int n = 128;
    std::vector<float> h(n, 1.f);
    float *a, *b;
    cudaMalloc(&a, n * sizeof(float));
    cudaMalloc(&b, n * sizeof(float));
    cudaMemcpy(a, h.data(), n * sizeof(float), cudaMemcpyHostToDevice);
    float *now = a, *next = b;
    for (int step = 0; step < 3; ++step) {
        heat<<<1, n>>>(now, next, n);
        float* kept = now;
        now = next;
        next = kept;
    }
    cudaMemcpy(h.data(), now, n * sizeof(float), cudaMemcpyDeviceToHost);
    printf("%g\n", h[0]);
    cudaFree(now);
    cudaFree(next);
    cudaFree(a);  // BUG: next is a or b
}
