// expect: bounds,watch error 10 out-of-bounds
// A product of matrices that are not square, with the row length of the wrong one.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void matmul(const float* a, const float* b, float* c, int m, int k, int n) {
    int col = blockIdx.x * blockDim.x + threadIdx.x, row = blockIdx.y * blockDim.y + threadIdx.y;
    if (row >= m || col >= n) return;
    float sum = 0;
    for (int i = 0; i < k; ++i) sum += a[row * n + i] * b[i * n + col];  // BUG: row * k
    c[row * n + col] = sum;
}
int main() {
    const int m = 16, k = 8, n = 24;
    std::vector<float> h(m * n, 1.f);
    float *a, *b, *c;
    cudaMalloc(&a, m * k * sizeof(float));
    cudaMalloc(&b, k * n * sizeof(float));
    cudaMalloc(&c, m * n * sizeof(float));
    cudaMemcpy(a, h.data(), m * k * sizeof(float), cudaMemcpyHostToDevice);
    cudaMemcpy(b, h.data(), k * n * sizeof(float), cudaMemcpyHostToDevice);
    matmul<<<dim3(3, 2), dim3(8, 8)>>>(a, b, c, m, k, n);
    cudaMemcpy(h.data(), c, m * n * sizeof(float), cudaMemcpyDeviceToHost);
    printf("%g\n", h[0]);
    cudaFree(a);
    cudaFree(b);
    cudaFree(c);
}
