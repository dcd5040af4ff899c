// expect: bounds,watch error 11 out-of-bounds
// A sparse matrix times a vector; the offsets of rows need one element more than there are rows.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void spmv(const int* offsets, const int* columns, const float* values, const float* x,
                     float* y, int rows) {
    int row = blockIdx.x * blockDim.x + threadIdx.x;
    if (row >= rows) return;
    float sum = 0;
    int end = offsets[row + 1];  // BUG: offsets was allocated with rows elements
    for (int k = offsets[row]; k < end; ++k) sum += values[k] * x[columns[k]];
    y[row] = sum;
}
template <class T> T* upload(const std::vector<T>& h) {
    T* d;
    cudaMalloc(&d, h.size() * sizeof(T));
    cudaMemcpy(d, h.data(), h.size() * sizeof(T), cudaMemcpyHostToDevice);
    return d;
}
int main() {
    const int rows = 64;
    std::vector<int> offsets, columns;
    for (int i = 0; i < rows; ++i) {
        offsets.push_back(2 * i);
        columns.push_back(i);
        columns.push_back((i + 1) % rows);
    }
    int *o = upload(offsets), *c = upload(columns);
    float *v = upload(std::vector<float>(2 * rows, 1.f)), *x = upload(std::vector<float>(rows, 1.f));
    float* y = upload(std::vector<float>(rows, 0.f));
    spmv<<<1, rows>>>(o, c, v, x, y, rows);
    float first;
    cudaMemcpy(&first, y, sizeof(float), cudaMemcpyDeviceToHost);
    printf("%g\n", first);
    cudaFree(o);
    cudaFree(c);
    cudaFree(v);
    cudaFree(x);
    cudaFree(y);
}
