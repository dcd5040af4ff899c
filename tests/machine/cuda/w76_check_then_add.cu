// expect: watch error 8|9 race
#include <cuda_runtime.h>
#include <cstdio>
// At most `most` threads are to take a ticket: the read and the atomicAdd() are two steps, so more do.
__global__ void k(int* tickets, int most) {
    // BUG: the check is not part of the atomic operation, and atomicAdd() does not check again as atomicCAS()
    // would.
    if (*tickets < most)
        atomicAdd(tickets, 1);
}
int main() {
    int* tickets;
    cudaMalloc(&tickets, sizeof(int));
    cudaMemset(tickets, 0, sizeof(int));
    k<<<4, 64>>>(tickets, 10);
    int taken = 0;
    cudaMemcpy(&taken, tickets, sizeof(int), cudaMemcpyDeviceToHost);
    printf("%s\n", taken > 0 ? "taken" : "none");
    cudaFree(tickets);
    return 0;
}
