// expect: races,watch error 10|13 race
// The tile is used before all of it is loaded.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
#define TILE 8
__global__ void transpose(const int* in, int* out, int n) {
    __shared__ int tile[TILE][TILE + 1];
    int x = blockIdx.x * TILE + threadIdx.x, y = blockIdx.y * TILE + threadIdx.y;
    tile[threadIdx.y][threadIdx.x] = in[y * n + x];  // BUG: a barrier is missing behind this line
    x = blockIdx.y * TILE + threadIdx.x;
    y = blockIdx.x * TILE + threadIdx.y;
    out[y * n + x] = tile[threadIdx.x][threadIdx.y];  // BUG
}
int main() {
    const int n = 16;
    std::vector<int> h(n * n);
    for (int i = 0; i < n * n; ++i) h[i] = i;
    int *in, *out;
    cudaMalloc(&in, n * n * sizeof(int));
    cudaMalloc(&out, n * n * sizeof(int));
    cudaMemcpy(in, h.data(), n * n * sizeof(int), cudaMemcpyHostToDevice);
    transpose<<<dim3(2, 2), dim3(TILE, TILE)>>>(in, out, n);
    cudaMemcpy(h.data(), out, n * n * sizeof(int), cudaMemcpyDeviceToHost);
    printf("%d\n", h[0]);
    cudaFree(in);
    cudaFree(out);
}
