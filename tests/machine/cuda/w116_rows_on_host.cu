// expect: plain,bounds,races,watch,order error 10 host-pointer
// A matrix as an array of rows: the rows are on the device, the array of pointers is not.
#include <cuda_runtime.h>
#include <cstdio>
__global__ void fill(float** rows, int columns) { rows[blockIdx.x][threadIdx.x] = blockIdx.x; }
int main() {
    const int count = 4, columns = 32;
    float* rows[count];
    for (int r = 0; r < count; ++r) cudaMalloc(&rows[r], columns * sizeof(float));
    fill<<<count, columns>>>(rows, columns);  // BUG: rows is an array of the host
    float first = 0;
    cudaMemset(rows[1], 0, columns * sizeof(float));
    cudaMemcpy(&first, rows[1], sizeof(float), cudaMemcpyDeviceToHost);
    printf("%g\n", first);
    for (int r = 0; r < count; ++r) cudaFree(rows[r]);
}
