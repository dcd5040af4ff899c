// The work-efficient scan. Blelloch 1990; GPU Gems 3, 39.2.2 and 39.2.3.
//
// A balanced tree over the sums of a block's threads, in shared memory and in place. On the way up
// each node gets the sum of its two children (a reduction); then the root is cleared, and on the
// way down each node hands its value to the left child, and the left child's sum plus its value to
// the right one. Both ways cost n - 1 additions, not n log n.
#include "common/device/device_array.h"
#include "common/task/not_implemented.h"
#include "common/wavefront/grid.h"
#include "labs/03_wavefront/scan_tiles.h"

namespace raylab::lab03 {

namespace {

// Shared memory has 32 banks, one word wide: words 32 apart share one, and threads that read them
// at once wait for each other. The tree's strides are powers of two, the worst there is; one idle
// word after every 32 spreads them.
__device__ constexpr int padded(int i) { return i + i / 32; }

__global__ void efficient_kernel(const std::uint32_t* in, std::uint32_t* out, std::int64_t n,
                                 std::uint32_t* sums) {
    __shared__ std::uint32_t tree[padded(tile_threads)];
    const int t = static_cast<int>(threadIdx.x);
    const std::int64_t first = global_index() * thread_items;
    std::uint32_t items[thread_items];
    // Steps:
    // 1. Load the thread's numbers; their sum is leaf t of the tree.
    // 2. Up, with strides 1, 2, 4, ...: a barrier, then the t-th node of the level takes in the sum
    //    that lies `stride` places before it.
    // 3. A barrier; one thread writes the root to sums, and then clears it.
    // 4. Down, with strides ..., 4, 2, 1: a barrier, then the t-th node hands its value to the
    //    place `stride` before it, and adds the sum that was there to its own.
    // 5. A barrier; store the numbers' scan behind what leaf t holds now.
    //[ task 3.2
    tree[padded(t)] = load_items(in, n, first, items);

    // Up: node i, the right end of 2 stride leaves, takes in its left sibling's sum.
    for (int stride = 1; stride < tile_threads; stride *= 2) {
        __syncthreads();
        const int i = (t + 1) * 2 * stride - 1;
        if (i < tile_threads) tree[padded(i)] += tree[padded(i - stride)];
    }
    __syncthreads();
    if (t == tile_threads - 1) {
        sums[blockIdx.x] = tree[padded(t)];
        tree[padded(t)] = 0;
    }
    // Down: a node's value, the sum of all before it, goes left; right of it comes the left sum.
    for (int stride = tile_threads / 2; stride > 0; stride /= 2) {
        __syncthreads();
        const int i = (t + 1) * 2 * stride - 1;
        if (i < tile_threads) {
            const std::uint32_t left = tree[padded(i - stride)];
            tree[padded(i - stride)] = tree[padded(i)];
            tree[padded(i)] += left;
        }
    }
    __syncthreads();
    store_scanned(out, n, first, items, tree[padded(t)]);
    //| not_implemented("3.2", "scan_efficient: efficient_kernel()");
    //]
}

} // namespace

void scan_efficient(const std::uint32_t* in, std::uint32_t* out, std::int64_t n,
                    std::uint32_t* workspace) {
    scan_by_tiles(efficient_kernel, in, out, n, workspace);
}

} // namespace raylab::lab03
