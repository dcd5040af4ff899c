// expect: watch error 11 uninitialised-shared; none error 9|11 foreign-shared
// A block stores the address of its shared memory, and a later kernel follows it.
#include <cuda_runtime.h>
#include <cstdio>
__global__ void build(int** out) {
    __shared__ int table[32];
    table[threadIdx.x] = threadIdx.x * threadIdx.x;
    __syncthreads();
    if (threadIdx.x == 0) *out = table;  // BUG: it ends with the block
}
__global__ void use(int** table, int* out) { out[threadIdx.x] = (*table)[threadIdx.x]; }  // BUG
int main() {
    int **table, *out, first = 0;
    cudaMalloc(&table, sizeof(int*));
    cudaMalloc(&out, 32 * sizeof(int));
    build<<<1, 32>>>(table);
    use<<<1, 32>>>(table, out);
    cudaMemcpy(&first, out, sizeof(int), cudaMemcpyDeviceToHost);
    printf("done\n");
    cudaFree(table);
    cudaFree(out);
}
