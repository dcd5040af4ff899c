// expect: nothing
// Floats and doubles in one allocation, the second part at a multiple of 8 bytes.
#include <cuda_runtime.h>
#include <cstdio>
__global__ void moments(const float* x, double* squares, int n) {
    for (int i = blockIdx.x * blockDim.x + threadIdx.x; i < n; i += gridDim.x * blockDim.x)
        squares[i] = double(x[i]) * x[i];
}
int main() {
    const int n = 77;
    const size_t start = (n * sizeof(float) + 7) / 8 * 8;
    float h[n];
    for (int i = 0; i < n; ++i) h[i] = i;
    char* pool;
    cudaMalloc(&pool, start + n * sizeof(double));
    float* x = (float*)pool;
    double* squares = (double*)(pool + start);
    cudaMemcpy(x, h, sizeof(h), cudaMemcpyHostToDevice);
    moments<<<2, 32>>>(x, squares, n);
    double last;
    cudaMemcpy(&last, squares + n - 1, sizeof(double), cudaMemcpyDeviceToHost);
    printf("%g\n", last);
    cudaFree(pool);
    return last != 76 * 76;
}
