// expect: watch error 6 uninitialised-global
// The counter of a queue is allocated and never set to 0.
#include <cuda_runtime.h>
#include <cstdio>
__global__ void push(int* queue, int* tail, int capacity) {
    int at = atomicAdd(tail, 1);  // BUG: *tail was never written
    if (at >= 0 && at < capacity) queue[at] = threadIdx.x;
}
int main() {
    const int capacity = 128;
    int *queue, *tail;
    cudaMalloc(&queue, capacity * sizeof(int));
    cudaMalloc(&tail, sizeof(int));
    push<<<1, 64>>>(queue, tail, capacity);
    cudaError_t e = cudaDeviceSynchronize();
    printf("%s\n", cudaGetErrorString(e));
    cudaFree(queue);
    cudaFree(tail);
}
