// expect: plain,bounds,races,watch,order error 7 division-by-zero
// The number of elements a thread is rounded down to 0, and then a divisor.
#include <cuda_runtime.h>
#include <cstdio>
__global__ void owners(int* owner, int n) {
    int i = threadIdx.x, chunk = n / blockDim.x;
    if (i < n) owner[i] = i / chunk;  // BUG: n is less than blockDim.x
}
int main() {
    const int n = 40;
    int *owner, first = 0;
    cudaMalloc(&owner, n * sizeof(int));
    owners<<<1, 64>>>(owner, n);
    cudaMemcpy(&first, owner, sizeof(int), cudaMemcpyDeviceToHost);
    printf("%d\n", first);
    cudaFree(owner);
}
