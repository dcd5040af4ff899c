// expect: bounds,watch error 10 out-of-bounds
// A queue has room for as many entries as there are parents, but each pushes two.
#include <cuda_runtime.h>
#include <cstdio>
__global__ void push_children(int* queue, int* tail, int parents) {
    int i = blockIdx.x * blockDim.x + threadIdx.x;
    if (i >= parents) return;
    int at = atomicAdd(tail, 2);
    queue[at] = 2 * i;
    queue[at + 1] = 2 * i + 1;  // BUG: nobody compares at with the capacity
}
int main() {
    const int parents = 33, capacity = 65;
    int *queue, *tail, size = 0;
    cudaMalloc(&queue, capacity * sizeof(int));
    cudaMalloc(&tail, sizeof(int));
    cudaMemset(tail, 0, sizeof(int));
    push_children<<<2, 32>>>(queue, tail, parents);
    cudaMemcpy(&size, tail, sizeof(int), cudaMemcpyDeviceToHost);
    printf("%d\n", size);
    cudaFree(queue);
    cudaFree(tail);
}
