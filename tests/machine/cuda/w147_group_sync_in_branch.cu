// expect: plain,bounds,races,watch,order error 15 exit-before-barrier|divergent-barrier
// sync() of the whole block, as a method of cooperative groups, in a branch of some threads.
#include <cooperative_groups.h>
#include <cuda_runtime.h>
#include <cstdio>
namespace cg = cooperative_groups;
__global__ void prefix(int* x) {
    cg::thread_block block = cg::this_thread_block();
    __shared__ int s[64];
    int t = block.thread_rank();
    s[t] = x[t];
    block.sync();
    if (t < 40) {
        int v = s[t] + s[t + 1];
        block.sync();  // BUG: threads 40 to 63 do not come
        s[t] = v;
    }
    x[t] = s[t];
}
int main() {
    int *x, first = 0;
    cudaMalloc(&x, 64 * sizeof(int));
    cudaMemset(x, 0, 64 * sizeof(int));
    prefix<<<1, 64>>>(x);
    cudaMemcpy(&first, x, sizeof(int), cudaMemcpyDeviceToHost);
    printf("%d\n", first);
    cudaFree(x);
}
