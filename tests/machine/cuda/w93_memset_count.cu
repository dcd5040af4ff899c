// expect: watch error 8 uninitialised-global
// cudaMemset() counts bytes: only a quarter of the counters starts at 0.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void degrees(const int* ends, int* degree, int edges) {
    int i = blockIdx.x * blockDim.x + threadIdx.x;
    if (i < edges) atomicAdd(&degree[ends[i]], 1);  // BUG: most of degree was never written
}
int main() {
    const int edges = 600, vertices = 100;
    std::vector<int> h(edges);
    for (int i = 0; i < edges; ++i) h[i] = (7 * i) % vertices;
    int *ends, *degree;
    cudaMalloc(&ends, edges * sizeof(int));
    cudaMalloc(&degree, vertices * sizeof(int));
    cudaMemcpy(ends, h.data(), edges * sizeof(int), cudaMemcpyHostToDevice);
    cudaMemset(degree, 0, vertices);
    degrees<<<(edges + 127) / 128, 128>>>(ends, degree, edges);
    cudaMemcpy(h.data(), degree, vertices * sizeof(int), cudaMemcpyDeviceToHost);
    printf("%d\n", h[0]);
    cudaFree(ends);
    cudaFree(degree);
}
