// expect: none error 7|19 deadlock|endless-loop|lock-order
// Transfers between accounts lock the payer first: two that pay each other wait for each other.
#include <cuda_runtime.h>
#include <cstdio>
__device__ int locks[4];
__device__ void lock(int i) {
    while (atomicCAS(&locks[i], 0, 1) != 0) {  // BUG
    }
    __threadfence();
}
__device__ void unlock(int i) {
    __threadfence();
    atomicExch(&locks[i], 0);
}
__global__ void transfer(int* balance, int rounds) {
    int from = blockIdx.x, to = (blockIdx.x + 1) % gridDim.x;
    for (int r = 0; r < rounds; ++r) {
        lock(from);
        lock(to);  // BUG: always lock the lower number first
        balance[from] -= 1;
        balance[to] += 1;
        unlock(to);
        unlock(from);
    }
}
int main() {
    int *balance, first = 0;
    cudaMalloc(&balance, 4 * sizeof(int));
    cudaMemset(balance, 0, 4 * sizeof(int));
    transfer<<<4, 1>>>(balance, 20);
    cudaMemcpy(&first, balance, sizeof(int), cudaMemcpyDeviceToHost);
    printf("%d\n", first);
    cudaFree(balance);
}
