// expect: races,watch error 7|11|13 race
// The lock is taken by an atomic and given back by a store.
#include <cuda_runtime.h>
#include <cstdio>
__global__ void append(int* list, int* size, int* lock) {
    if (threadIdx.x != 0) return;
    while (atomicCAS(lock, 0, 1) != 0) {  // BUG
    }
    __threadfence();
    list[*size] = blockIdx.x;
    *size += 1;  // BUG
    __threadfence();
    *lock = 0;  // BUG: atomicExch(lock, 0)
}
int main() {
    int *list, *size, *lock, result = 0;
    cudaMalloc(&list, 8 * sizeof(int));
    cudaMalloc(&size, sizeof(int));
    cudaMalloc(&lock, sizeof(int));
    cudaMemset(list, 0, 8 * sizeof(int));
    cudaMemset(size, 0, sizeof(int));
    cudaMemset(lock, 0, sizeof(int));
    append<<<8, 32>>>(list, size, lock);
    cudaMemcpy(&result, size, sizeof(int), cudaMemcpyDeviceToHost);
    printf("%d\n", result);
    cudaFree(list);
    cudaFree(size);
    cudaFree(lock);
}
