// expect: races,watch error 13 race
// Each warp was meant to have bins of its own, but the number of the warp is computed wrongly.
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
__global__ void histogram(const int* x, int n, int* bins) {
    __shared__ int local[2][16];
    int t = threadIdx.x, warp = t / 64, lane = t % 32;
    if (t < 32) local[t / 16][t % 16] = 0;
    __syncthreads();
    for (int i = t; i < n; i += blockDim.x) {
        for (int turn = 0; turn < 32; ++turn) {  // one lane after the other
            if (turn == lane) local[warp][x[i] % 16] += 1;  // BUG: t / 32
            __syncwarp();
        }
    }
    __syncthreads();
    if (t < 16) bins[t] = local[0][t] + local[1][t];
}
int main() {
    const int n = 128;
    std::vector<int> h(n);
    for (int i = 0; i < n; ++i) h[i] = i;
    int *x, *bins;
    cudaMalloc(&x, n * sizeof(int));
    cudaMalloc(&bins, 16 * sizeof(int));
    cudaMemcpy(x, h.data(), n * sizeof(int), cudaMemcpyHostToDevice);
    histogram<<<1, 64>>>(x, n, bins);
    cudaMemcpy(h.data(), bins, 16 * sizeof(int), cudaMemcpyDeviceToHost);
    printf("%d\n", h[0] > 0);
    cudaFree(x);
    cudaFree(bins);
}
