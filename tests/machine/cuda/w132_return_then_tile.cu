// expect: plain,bounds,races,watch,order error 15|17 exit-before-barrier
// Threads beyond the matrix return, and the others wait for them at the barriers of the tiles.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
#define TILE 8
__global__ void matmul(const float* a, const float* b, float* c, int n) {
    __shared__ float sa[TILE][TILE], sb[TILE][TILE];
    int tx = threadIdx.x, ty = threadIdx.y, col = blockIdx.x * TILE + tx, row = blockIdx.y * TILE + ty;
    if (row >= n || col >= n) return;
    float sum = 0;
    for (int k0 = 0; k0 < n; k0 += TILE) {
        sa[ty][tx] = k0 + tx < n ? a[row * n + k0 + tx] : 0;
        sb[ty][tx] = k0 + ty < n ? b[(k0 + ty) * n + col] : 0;
        __syncthreads();  // BUG
        for (int k = 0; k < TILE && k0 + k < n; ++k) sum += sa[ty][k] * sb[k][tx];
        __syncthreads();  // BUG
    }
    c[row * n + col] = sum;
}
int main() {
    const int n = 20;
    std::vector<float> h(n * n, 1.f);
    float *a, *b, *c;
    cudaMalloc(&a, n * n * sizeof(float));
    cudaMalloc(&b, n * n * sizeof(float));
    cudaMalloc(&c, n * n * sizeof(float));
    cudaMemcpy(a, h.data(), n * n * sizeof(float), cudaMemcpyHostToDevice);
    cudaMemcpy(b, h.data(), n * n * sizeof(float), cudaMemcpyHostToDevice);
    matmul<<<dim3(3, 3), dim3(TILE, TILE)>>>(a, b, c, n);
    cudaMemcpy(h.data(), c, n * n * sizeof(float), cudaMemcpyDeviceToHost);
    printf("%g\n", h[0]);
    cudaFree(a);
    cudaFree(b);
    cudaFree(c);
}
