// expect: races,watch error 11|12 race
// Forces are added to both partners of a pair, and each particle is in many pairs.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void forces(const float* x, float* f, int n) {
    int i = blockIdx.x * blockDim.x + threadIdx.x;
    if (i >= n) return;
    for (int j = i + 1; j < n; ++j) {
        float d = x[j] - x[i], force = 1 / (d * d);
        f[i] += force;  // BUG
        f[j] -= force;  // BUG: another thread adds to f[j], too
    }
}
int main() {
    const int n = 48;
    std::vector<float> h(n);
    for (int i = 0; i < n; ++i) h[i] = i;
    float *x, *f;
    cudaMalloc(&x, n * sizeof(float));
    cudaMalloc(&f, n * sizeof(float));
    cudaMemcpy(x, h.data(), n * sizeof(float), cudaMemcpyHostToDevice);
    cudaMemset(f, 0, n * sizeof(float));
    forces<<<1, 64>>>(x, f, n);
    cudaMemcpy(h.data(), f, n * sizeof(float), cudaMemcpyDeviceToHost);
    printf("%d\n", h[0] > 0);
    cudaFree(x);
    cudaFree(f);
}
