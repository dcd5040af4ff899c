// expect: plain,bounds,races,watch,order error 12|23 bad-launch|misuse|trap
// grid.sync() needs cudaLaunchCooperativeKernel().
#include <cooperative_groups.h>
#include <cuda_runtime.h>
#include <cstdio>
namespace cg = cooperative_groups;
__global__ void jacobi(float* a, float* b, int n) {
    cg::grid_group grid = cg::this_grid();
    int i = grid.thread_rank();
    for (int step = 0; step < 2; ++step) {
        if (i > 0 && i < n - 1) b[i] = 0.5f * (a[i - 1] + a[i + 1]);
        grid.sync();  // BUG: not launched as a cooperative kernel
        float* c = a; a = b; b = c;
    }
}
int main() {
    const int n = 64;
    float *a, *b;
    cudaMalloc(&a, n * sizeof(float));
    cudaMalloc(&b, n * sizeof(float));
    cudaMemset(a, 0, n * sizeof(float));
    cudaMemset(b, 0, n * sizeof(float));
    jacobi<<<2, 32>>>(a, b, n);  // BUG
    cudaError_t e = cudaDeviceSynchronize();
    printf("%s\n", e == cudaSuccess ? "done" : "failed");
    cudaFree(a);
    cudaFree(b);
}
