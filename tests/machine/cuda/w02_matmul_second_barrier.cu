// expect: races,watch error 11|12|15 race
#include <cuda_runtime.h>
#include <cstdio>
#include <cstdlib>
#include <vector>
__global__ void mm(const float* a, float* c, int n) {
    __shared__ float A[8][8], B[8][8];
    int x = threadIdx.x, y = threadIdx.y;
    float sum = 0;
    for (int t = 0; t < n / 8; ++t) {
        A[y][x] = a[(blockIdx.y * 8 + y) * n + t * 8 + x];  // BUG
        B[y][x] = a[(t * 8 + y) * n + blockIdx.x * 8 + x];  // BUG
        __syncthreads();
        for (int i = 0; i < 8; ++i)
            sum += A[y][i] * B[i][x];  // BUG
    }
    c[(blockIdx.y * 8 + y) * n + blockIdx.x * 8 + x] = sum;
}
int main() {
    const int n = 256;
    std::vector<float> h(n);
    for (int i = 0; i < n; ++i) h[i] = i % 7;
    float *a, *b;
    cudaMalloc(&a, n * sizeof(float));
    cudaMalloc(&b, n * sizeof(float));
    cudaMemcpy(a, h.data(), n * sizeof(float), cudaMemcpyHostToDevice);
    cudaMemset(b, 0, n * sizeof(float));
    mm<<<dim3(2, 2), dim3(8, 8)>>>(a, b, 16);
    cudaMemcpy(h.data(), b, n * sizeof(float), cudaMemcpyDeviceToHost);
    printf("%g %g\n", h[0], h[n - 1]);
    cudaFree(a);
    cudaFree(b);
    cudaError_t e = cudaDeviceSynchronize();
    printf("status: %s\n", cudaGetErrorString(e));
    return e != cudaSuccess;
}
