// expect: nothing
// Cooperative groups: tiles of 8 sum by shuffles, the block meets by sync().
#include <cooperative_groups.h>
#include <cuda_runtime.h>
#include <cstdio>
#include <vector>
namespace cg = cooperative_groups;
__global__ void sum(const int* in, int* out) {
    __shared__ int sums[12];
    cg::thread_block block = cg::this_thread_block();
    cg::thread_block_tile<8> tile = cg::tiled_partition<8>(block);
    int v = in[block.thread_rank()];
    for (int d = tile.size() / 2; d > 0; d /= 2) v += tile.shfl_down(v, d);
    if (tile.thread_rank() == 0) sums[tile.meta_group_rank()] = v;
    block.sync();
    if (block.thread_rank() == 0) {
        int total = 0;
        for (int i = 0; i < 12; ++i) total += sums[i];
        *out = total;
    }
}
int main() {
    std::vector<int> h(96, 2);
    int *in, *out, result;
    cudaMalloc(&in, 96 * sizeof(int));
    cudaMalloc(&out, sizeof(int));
    cudaMemcpy(in, h.data(), 96 * sizeof(int), cudaMemcpyHostToDevice);
    sum<<<1, 96>>>(in, out);
    cudaMemcpy(&result, out, sizeof(int), cudaMemcpyDeviceToHost);
    printf("%d\n", result);
    cudaFree(in);
    cudaFree(out);
    return result != 192;
}
