// expect: plain,bounds,races,watch,order error 13 endless-loop|deadlock
// A barrier of the grid by a counter, with more blocks than any GPU holds at a time.
#include <cuda_runtime.h>
#include <cstdio>
__device__ unsigned arrived;
__global__ void two_phases(int* x) {
    int i = blockIdx.x * blockDim.x + threadIdx.x;
    x[i] = i;
    __threadfence();
    __syncthreads();
    if (threadIdx.x == 0) {
        atomicAdd(&arrived, 1);
        while (atomicAdd(&arrived, 0) < gridDim.x) {  // BUG: later blocks cannot start
        }
        __threadfence();
    }
    __syncthreads();
    x[i] += 1;
}
int main() {
    const int blocks = 20000;
    int *x, first = 0;
    cudaMalloc(&x, blocks * 32 * sizeof(int));
    two_phases<<<blocks, 32>>>(x);
    cudaMemcpy(&first, x, sizeof(int), cudaMemcpyDeviceToHost);
    printf("%d\n", first);
    cudaFree(x);
}
