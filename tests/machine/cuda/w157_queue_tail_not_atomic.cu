// expect: races,watch error 11|13 race
// Neighbours are appended to the next frontier with an ordinary increment.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void expand(const int* frontier, int size, int* next, int* tail) {
    int i = blockIdx.x * blockDim.x + threadIdx.x;
    if (i >= size) return;
    int node = frontier[i];
    if (node % 2 == 0) {
        int at = *tail;  // BUG: atomicAdd(tail, 1)
        next[at] = 2 * node + 1;
        *tail = at + 1;  // BUG
    }
}
int main() {
    const int n = 64;
    std::vector<int> h(n);
    for (int i = 0; i < n; ++i) h[i] = i;
    int *frontier, *next, *tail, size = 0;
    cudaMalloc(&frontier, n * sizeof(int));
    cudaMalloc(&next, n * sizeof(int));
    cudaMalloc(&tail, sizeof(int));
    cudaMemcpy(frontier, h.data(), n * sizeof(int), cudaMemcpyHostToDevice);
    cudaMemset(next, 0, n * sizeof(int));
    cudaMemset(tail, 0, sizeof(int));
    expand<<<2, 32>>>(frontier, n, next, tail);
    cudaMemcpy(&size, tail, sizeof(int), cudaMemcpyDeviceToHost);
    printf("%d\n", size > 0);
    cudaFree(frontier);
    cudaFree(next);
    cudaFree(tail);
}
