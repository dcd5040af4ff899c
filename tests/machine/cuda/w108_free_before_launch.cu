// expect: plain,bounds,races,watch,order error 25 freed-pointer|use-after-free
// The input is freed before the second kernel, which still reads it.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void mean(const float* x, float* m, int n) {
    float sum = 0;
    for (int i = 0; i < n; ++i) sum += x[i];
    *m = sum / n;
}
__global__ void center(const float* x, const float* m, float* y, int n) {
    int i = blockIdx.x * blockDim.x + threadIdx.x;
    if (i < n) y[i] = x[i] - *m;
}
int main() {
    const int n = 256;
    std::vector<float> h(n, 3.f);
    float *x, *m, *y;
    cudaMalloc(&x, n * sizeof(float));
    cudaMalloc(&m, sizeof(float));
    cudaMalloc(&y, n * sizeof(float));
    cudaMemcpy(x, h.data(), n * sizeof(float), cudaMemcpyHostToDevice);
    mean<<<1, 1>>>(x, m, n);
    cudaFree(x);
    center<<<2, 128>>>(x, m, y, n);  // BUG: x is freed
    cudaMemcpy(h.data(), y, n * sizeof(float), cudaMemcpyDeviceToHost);
    printf("%g\n", h[0]);
    cudaFree(m);
    cudaFree(y);
}
