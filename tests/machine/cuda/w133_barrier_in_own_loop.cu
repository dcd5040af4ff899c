// expect: plain,bounds,races,watch,order error 13 exit-before-barrier|divergent-barrier
// Each thread iterates until its own value has converged, with a barrier in the loop.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void roots(float* x) {
    __shared__ float guess[64];
    int t = threadIdx.x;
    float value = x[t];
    guess[t] = value;
    while (fabsf(guess[t] * guess[t] - value) > 1e-3f * value) {
        guess[t] = 0.5f * (guess[t] + value / guess[t]);
        __syncthreads();  // BUG: threads leave the loop at different times
    }
    x[t] = guess[t];
}
int main() {
    std::vector<float> h(64);
    for (int i = 0; i < 64; ++i) h[i] = 1 + i * i;
    float* x;
    cudaMalloc(&x, 64 * sizeof(float));
    cudaMemcpy(x, h.data(), 64 * sizeof(float), cudaMemcpyHostToDevice);
    roots<<<1, 64>>>(x);
    cudaMemcpy(h.data(), x, 64 * sizeof(float), cudaMemcpyDeviceToHost);
    printf("%g\n", h[0]);
    cudaFree(x);
}
