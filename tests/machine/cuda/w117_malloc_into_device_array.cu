// expect: plain,bounds,races,watch,order error 11 host-dereference|host-writes-device|bad-allocation
// cudaMalloc() is told to write the pointer of a row into device memory.
#include <cuda_runtime.h>
#include <cstdio>
__global__ void fill(float** rows) { rows[blockIdx.x][threadIdx.x] = blockIdx.x; }
int main() {
    const int count = 4, columns = 32;
    float** rows;
    cudaMalloc(&rows, count * sizeof(float*));
    for (int r = 0; r < count; ++r)
        cudaMalloc(&rows[r], columns * sizeof(float));  // BUG: &rows[r] is a device pointer
    fill<<<count, columns>>>(rows);
    cudaDeviceSynchronize();
    printf("done\n");
    cudaFree(rows);
}
