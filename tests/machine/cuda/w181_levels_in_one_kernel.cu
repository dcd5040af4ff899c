// expect: races,watch error 9|11 race
// All levels of a breadth-first search in one kernel of several blocks, with a block's barrier.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void bfs(const int* neighbour, int* level, int n, int depth) {
    int i = blockIdx.x * blockDim.x + threadIdx.x;
    for (int d = 0; d < depth; ++d) {
        if (i < n && level[i] == d) {  // BUG
            int j = neighbour[i];
            if (level[j] < 0) level[j] = d + 1;  // BUG: of another block
        }
        __syncthreads();
    }
}
int main() {
    const int n = 128;
    std::vector<int> next(n), h(n, -1);
    for (int i = 0; i < n; ++i) next[i] = (i + 40) % n;
    h[0] = 0;
    int *neighbour, *level;
    cudaMalloc(&neighbour, n * sizeof(int));
    cudaMalloc(&level, n * sizeof(int));
    cudaMemcpy(neighbour, next.data(), n * sizeof(int), cudaMemcpyHostToDevice);
    cudaMemcpy(level, h.data(), n * sizeof(int), cudaMemcpyHostToDevice);
    bfs<<<4, 32>>>(neighbour, level, n, 4);
    cudaMemcpy(h.data(), level, n * sizeof(int), cudaMemcpyDeviceToHost);
    printf("%d\n", h[0]);
    cudaFree(neighbour);
    cudaFree(level);
}
