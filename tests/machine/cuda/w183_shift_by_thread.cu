// expect: bounds warning 8 invalid-shift
// A mask of the lanes below this one, shifted by the thread's number in the block.
#include <cuda_runtime.h>
#include <cstdio>
__global__ void ranks(const int* keep, int* rank) {
    int t = threadIdx.x;
    unsigned votes = __ballot_sync(0xffffffff, keep[t] != 0);
    unsigned below = (1u << t) - 1;  // BUG: t % 32
    rank[t] = __popc(votes & below);
}
int main() {
    int *keep, *rank, last = 0;
    cudaMalloc(&keep, 64 * sizeof(int));
    cudaMalloc(&rank, 64 * sizeof(int));
    cudaMemset(keep, 1, 64 * sizeof(int));
    ranks<<<1, 64>>>(keep, rank);
    cudaMemcpy(&last, rank + 31, sizeof(int), cudaMemcpyDeviceToHost);
    printf("%d\n", last);
    cudaFree(keep);
    cudaFree(rank);
}
