// expect: nothing
// Two locks, always the lower one first, with fences.
#include <cuda_runtime.h>
#include <cstdio>
__device__ int locks[4];
__device__ void lock(int i) {
    while (atomicCAS(&locks[i], 0, 1) != 0) {
    }
    __threadfence();
}
__device__ void unlock(int i) {
    __threadfence();
    atomicExch(&locks[i], 0);
}
__global__ void transfer(int* balance, int rounds) {
    if (threadIdx.x != 0) return;
    int from = blockIdx.x, to = (blockIdx.x + 1) % gridDim.x;
    for (int r = 0; r < rounds; ++r) {
        lock(min(from, to));
        lock(max(from, to));
        balance[from] -= 1;
        balance[to] += 2;
        unlock(max(from, to));
        unlock(min(from, to));
    }
}
int main() {
    int *balance, h[4];
    cudaMalloc(&balance, sizeof(h));
    cudaMemset(balance, 0, sizeof(h));
    transfer<<<4, 32>>>(balance, 10);
    cudaMemcpy(h, balance, sizeof(h), cudaMemcpyDeviceToHost);
    printf("%d %d\n", h[0], h[3]);
    cudaFree(balance);
    return h[0] != 10 || h[3] != 10;
}
