// expect: plain,races,watch,order error 12 exit-before-barrier|divergent-barrier|deadlock|endless-loop; maybe error 22 bad-launch
// Blocks without work return, and the others wait for them at the barrier of the grid.
#include <cooperative_groups.h>
#include <cuda_runtime.h>
#include <cstdio>
namespace cg = cooperative_groups;
__global__ void two_steps(int* x, int n) {
    cg::grid_group grid = cg::this_grid();
    int i = blockIdx.x * blockDim.x + threadIdx.x;
    if (i >= n) return;
    x[i] = i;
    grid.sync();  // BUG: the last block never comes
    int right = x[(i + 1) % n];
    grid.sync();
    x[i] = right;
}
int main() {
    int n = 96, *x, first = 0;
    cudaMalloc(&x, n * sizeof(int));
    cudaMemset(x, 0, n * sizeof(int));
    void* arguments[] = {&x, &n};
    cudaLaunchCooperativeKernel((void*)two_steps, dim3(4), dim3(32), arguments, 0, 0);
    cudaMemcpy(&first, x, sizeof(int), cudaMemcpyDeviceToHost);
    printf("%d\n", first);
    cudaFree(x);
}
