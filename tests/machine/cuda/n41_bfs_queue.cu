// expect: nothing
// Breadth-first search with queues: atomicCAS() claims a node, atomicAdd() gives its place.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void expand(const int* frontier, int size, int n, int* level, int depth, int* next, int* tail) {
    int i = blockIdx.x * blockDim.x + threadIdx.x;
    if (i >= size) return;
    int node = frontier[i];
    for (int k = 1; k <= 2; ++k) {
        int child = (2 * node + k) % n;
        if (atomicCAS(&level[child], -1, depth + 1) == -1) next[atomicAdd(tail, 1)] = child;
    }
}
int main() {
    const int n = 300;
    std::vector<int> h(n, -1);
    h[0] = 0;
    int *level, *a, *b, *tail;
    cudaMalloc(&level, n * sizeof(int));
    cudaMalloc(&a, n * sizeof(int));
    cudaMalloc(&b, n * sizeof(int));
    cudaMalloc(&tail, sizeof(int));
    cudaMemcpy(level, h.data(), n * sizeof(int), cudaMemcpyHostToDevice);
    cudaMemset(a, 0, sizeof(int));
    int size = 1, depth = 0;
    while (size > 0) {
        cudaMemset(tail, 0, sizeof(int));
        expand<<<(size + 31) / 32, 32>>>(a, size, n, level, depth++, b, tail);
        cudaMemcpy(&size, tail, sizeof(int), cudaMemcpyDeviceToHost);
        std::swap(a, b);
    }
    cudaMemcpy(h.data(), level, n * sizeof(int), cudaMemcpyDeviceToHost);
    int reached = 0;
    for (int l : h) reached += l >= 0;
    printf("%d of %d, depth %d\n", reached, n, depth);
    cudaFree(level);
    cudaFree(a);
    cudaFree(b);
    cudaFree(tail);
}
