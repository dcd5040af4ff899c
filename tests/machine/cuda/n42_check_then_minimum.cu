// expect: nothing
// A plain read saves atomicMin() where it cannot improve: a stale value costs time only.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void relax(const int* from, const int* to, const int* length, int edges, int* distance) {
    int i = blockIdx.x * blockDim.x + threadIdx.x;
    if (i >= edges) return;
    int start = atomicAdd(&distance[from[i]], 0);
    if (start == 1000000) return;
    int candidate = start + length[i];
    if (candidate < distance[to[i]]) atomicMin(&distance[to[i]], candidate);
}
int main() {
    const int n = 40, edges = 3 * n;
    std::vector<int> from, to, length, h(n, 1000000);
    for (int i = 0; i < edges; ++i) {
        from.push_back(i % n);
        to.push_back((i * 7 + 1) % n);
        length.push_back(1 + i % 5);
    }
    h[0] = 0;
    int *f, *t, *l, *distance;
    cudaMalloc(&f, edges * sizeof(int));
    cudaMalloc(&t, edges * sizeof(int));
    cudaMalloc(&l, edges * sizeof(int));
    cudaMalloc(&distance, n * sizeof(int));
    cudaMemcpy(f, from.data(), edges * sizeof(int), cudaMemcpyHostToDevice);
    cudaMemcpy(t, to.data(), edges * sizeof(int), cudaMemcpyHostToDevice);
    cudaMemcpy(l, length.data(), edges * sizeof(int), cudaMemcpyHostToDevice);
    cudaMemcpy(distance, h.data(), n * sizeof(int), cudaMemcpyHostToDevice);
    for (int round = 0; round < n; ++round) relax<<<4, 32>>>(f, t, l, edges, distance);
    cudaMemcpy(h.data(), distance, n * sizeof(int), cudaMemcpyDeviceToHost);
    printf("%d %d\n", h[1], h[n - 1]);
    cudaFree(f);
    cudaFree(t);
    cudaFree(l);
    cudaFree(distance);
}
