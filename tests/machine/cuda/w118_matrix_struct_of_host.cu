// expect: watch error 14|15 host-memory
// The struct of a matrix is passed by value; its elements are still on the host.
#include <cuda_runtime.h>
#include <cstdio>
#include <cstdlib>
struct Matrix {
    int rows, columns;
    float* elements;
    __host__ __device__ float& at(int r, int c) { return elements[r * columns + c]; }
};
__global__ void add(Matrix a, Matrix b, Matrix c) {
    int col = threadIdx.x, row = blockIdx.x;
    if (row < a.rows && col < a.columns)
        c.at(row, col) = a.at(row, col)  // BUG: a.elements was never copied
                         + b.at(row, col);  // BUG
}
int main() {
    const int rows = 8, columns = 16;
    Matrix h{rows, columns, (float*)malloc(rows * columns * sizeof(float))}, d = h;
    for (int i = 0; i < rows * columns; ++i) h.elements[i] = i;
    cudaMalloc(&d.elements, rows * columns * sizeof(float));
    add<<<rows, columns>>>(h, h, d);
    float first;
    cudaMemcpy(&first, d.elements, sizeof(float), cudaMemcpyDeviceToHost);
    printf("%g\n", first);
    cudaFree(d.elements);
    free(h.elements);
}
