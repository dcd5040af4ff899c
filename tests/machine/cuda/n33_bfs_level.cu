// expect: nothing (yet race)
#include <cuda_runtime.h>
#include <cstdio>
#include <cstdlib>
#include <vector>
__global__ void k(const int* off, const int* adj, int* level, int cur, int n) {
    int v = blockIdx.x * blockDim.x + threadIdx.x;
    if (v < n && level[v] == cur)
        for (int e = off[v]; e < off[v + 1]; ++e) if (level[adj[e]] < 0) level[adj[e]] = cur + 1;
}
int main() {
    const int n = 256;
    std::vector<float> h(n);
    for (int i = 0; i < n; ++i) h[i] = i % 7;
    float *a, *b;
    cudaMalloc(&a, n * sizeof(float));
    cudaMalloc(&b, n * sizeof(float));
    cudaMemcpy(a, h.data(), n * sizeof(float), cudaMemcpyHostToDevice);
    cudaMemset(b, 0, n * sizeof(float));
    int off[5] = {0, 2, 4, 5, 6}, adj[6] = {1, 2, 3, 0, 3, 1}, lv[4] = {0, -1, -1, -1}; int *o, *d, *l;
    cudaMalloc(&o, sizeof off); cudaMalloc(&d, sizeof adj); cudaMalloc(&l, sizeof lv);
    cudaMemcpy(o, off, sizeof off, cudaMemcpyHostToDevice); cudaMemcpy(d, adj, sizeof adj, cudaMemcpyHostToDevice); cudaMemcpy(l, lv, sizeof lv, cudaMemcpyHostToDevice);
    for (int i = 0; i < 3; ++i) k<<<1, 32>>>(o, d, l, i, 4);
    cudaFree(o); cudaFree(d); cudaFree(l);
    cudaMemcpy(h.data(), b, n * sizeof(float), cudaMemcpyDeviceToHost);
    printf("%g %g\n", h[0], h[n - 1]);
    cudaFree(a);
    cudaFree(b);
    cudaError_t e = cudaDeviceSynchronize();
    printf("status: %s\n", cudaGetErrorString(e));
    return e != cudaSuccess;
}
