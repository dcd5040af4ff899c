// Where a thread stands in its grid, and its place in a queue. For files of kernels.
#pragma once

#include "common/math/hd.h"
#include "common/simt/cuda.h"

#include <cstdint>

namespace raylab {

// The index of a thread over a whole grid. The product of blockIdx.x and blockDim.x, both 32 bit,
// wraps at 2^32, and as int at 2^31: one factor must be made wide before.
HD constexpr std::int64_t grid_index(unsigned block, unsigned block_size, unsigned thread) {
    return static_cast<std::int64_t>(block) * block_size + thread;
}
static_assert(grid_index(1u << 21, 1024, 7) == (std::int64_t{1} << 31) + 7);
static_assert(grid_index(0x7fffffffu, 1024, 1023) == (std::int64_t{1} << 41) - 1);
__device__ inline std::int64_t global_index() {
    return grid_index(blockIdx.x, blockDim.x, threadIdx.x);
}

// Puts the slot at the end of a queue that has `size` slots so far. The order of the slots depends
// on the order of the threads. The image does not, because paths share nothing.
__device__ inline void push(int* queue, int& size, int slot) { queue[atomicAdd(&size, 1)] = slot; }

} // namespace raylab
