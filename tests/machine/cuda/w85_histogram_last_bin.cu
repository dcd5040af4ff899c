// expect: bounds,watch error 9 out-of-bounds
// The greatest value falls into a bin that does not exist.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void histogram(const float* values, int* bins, int n, int count, float low, float high) {
    for (int i = blockIdx.x * blockDim.x + threadIdx.x; i < n; i += gridDim.x * blockDim.x) {
        int bin = int((values[i] - low) / (high - low) * count);
        atomicAdd(bins + bin, 1);  // BUG: values[i] == high gives bin == count
    }
}
int main() {
    const int n = 1001, count = 10;
    std::vector<float> h(n);
    for (int i = 0; i < n; ++i) h[i] = i / 1000.f;
    float* values;
    int* bins;
    cudaMalloc(&values, n * sizeof(float));
    cudaMalloc(&bins, count * sizeof(int));
    cudaMemcpy(values, h.data(), n * sizeof(float), cudaMemcpyHostToDevice);
    cudaMemset(bins, 0, count * sizeof(int));
    histogram<<<2, 128>>>(values, bins, n, count, 0.f, 1.f);
    int first;
    cudaMemcpy(&first, bins, sizeof(int), cudaMemcpyDeviceToHost);
    printf("%d\n", first);
    cudaFree(values);
    cudaFree(bins);
}
