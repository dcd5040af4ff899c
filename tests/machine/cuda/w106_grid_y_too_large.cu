// expect: plain,bounds,races,watch,order error 18 bad-launch
// A grid has at most 65,535 blocks in y: here each row is a block.
#include <cuda_runtime.h>
#include <cstdio>
__global__ void row_sums(const float* m, float* sums, int columns) {
    int row = blockIdx.y;
    float sum = 0;
    for (int c = 0; c < columns; ++c) sum += m[row * columns + c];
    sums[row] = sum;
}
int main() {
    const int rows = 70000, columns = 2;
    float *m, *sums;
    cudaMalloc(&m, rows * columns * sizeof(float));
    cudaMalloc(&sums, rows * sizeof(float));
    cudaMemset(m, 0, rows * columns * sizeof(float));
    cudaMemset(sums, 0, rows * sizeof(float));
    row_sums<<<dim3(1, rows), 1>>>(m, sums, columns);  // BUG
    float last;
    cudaMemcpy(&last, sums + rows - 1, sizeof(float), cudaMemcpyDeviceToHost);
    printf("%g\n", last);
    cudaFree(m);
    cudaFree(sums);
}
