// expect: nothing
// The first block to come writes, the second waits: fences on both sides of an atomic flag.
#include <cuda_runtime.h>
#include <cstdio>
__device__ unsigned turn;
__global__ void hand_over(int* data, int* ready, int* out) {
    __shared__ unsigned mine;
    if (threadIdx.x == 0) mine = atomicAdd(&turn, 1);
    __syncthreads();
    if (mine == 0) {
        data[threadIdx.x] = 10 * threadIdx.x;
        __threadfence();
        __syncthreads();
        if (threadIdx.x == 0) atomicExch(ready, 1);
    } else {
        if (threadIdx.x == 0)
            while (atomicAdd(ready, 0) == 0) {
            }
        __syncthreads();
        __threadfence();
        out[threadIdx.x] = data[threadIdx.x];
    }
}
int main() {
    int *data, *ready, *out, last;
    cudaMalloc(&data, 64 * sizeof(int));
    cudaMalloc(&ready, sizeof(int));
    cudaMalloc(&out, 64 * sizeof(int));
    cudaMemset(ready, 0, sizeof(int));
    hand_over<<<2, 64>>>(data, ready, out);
    cudaMemcpy(&last, out + 63, sizeof(int), cudaMemcpyDeviceToHost);
    printf("%d\n", last);
    cudaFree(data);
    cudaFree(ready);
    cudaFree(out);
    return last != 630;
}
