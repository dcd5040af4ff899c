// expect: nothing
// Whole warps without work return; the others use shuffles of all lanes and no barrier of the block.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void row_sums(const float* m, float* sums, int rows, int columns) {
    int row = (blockIdx.x * blockDim.x + threadIdx.x) / 32, lane = threadIdx.x % 32;
    if (row >= rows) return;
    float sum = 0;
    for (int c = lane; c < columns; c += 32) sum += m[row * columns + c];
    for (int d = 16; d > 0; d /= 2) sum += __shfl_xor_sync(0xffffffff, sum, d);
    if (lane == 0) sums[row] = sum;
}
int main() {
    const int rows = 6, columns = 50;
    std::vector<float> h(rows * columns, 1.f);
    float *m, *sums, last;
    cudaMalloc(&m, h.size() * sizeof(float));
    cudaMalloc(&sums, rows * sizeof(float));
    cudaMemcpy(m, h.data(), h.size() * sizeof(float), cudaMemcpyHostToDevice);
    row_sums<<<2, 128>>>(m, sums, rows, columns);
    cudaMemcpy(&last, sums + rows - 1, sizeof(float), cudaMemcpyDeviceToHost);
    printf("%g\n", last);
    cudaFree(m);
    cudaFree(sums);
    return last != columns;
}
