// How many blocks a launch has, how many of them the device works on at a time, and so in how many
// batches it runs: the lecture's "10 blocks executing in groups of 4 = 3 batches".
//
// A block runs on one multiprocessor, which takes as many blocks as fit into its threads, its
// shared memory and its registers: the *occupancy*. With fewer blocks than fit, part of the device
// stands idle, however few rays are left. CUDA C++ Programming Guide, 5.2.3.
#pragma once

#include "common/device/launch.h"
#include "common/task/not_implemented.h"

#include <algorithm>

namespace raylab::lab03 {

struct LaunchSize {
    int blocks = 0;    // of this launch
    int in_flight = 1; // blocks that the device holds at a time
    int batches = 0;   // of `in_flight` blocks, the last one perhaps not full
};

// threads: of the launch, one a path. in_flight: from blocks_in_flight().
inline LaunchSize launch_size(std::int64_t threads, int block, int in_flight) {
    // Steps:
    // 1. Blocks: as many as the threads need; the last one may be part full.
    // 2. Batches: as many as the blocks need, rounded up in the same way.
    //[ task 3.6
    const int blocks = blocks_for(threads, block);
    return {blocks, in_flight, (blocks + in_flight - 1) / in_flight};
    //| not_implemented("3.6", "launch_size()");
    //| return {blocks_for(threads, block), 1, 1};
    //]
}

// Blocks of `kernel` that the device holds at a time. shared_bytes: dynamic shared memory a block.
template <class Kernel>
int blocks_in_flight(Kernel* kernel, int block, std::size_t shared_bytes = 0) {
    cudaDeviceProp device{};
    check(cudaGetDeviceProperties(&device, 0), "cudaGetDeviceProperties");
    int each = 0; // blocks a multiprocessor
    check(cudaOccupancyMaxActiveBlocksPerMultiprocessor(&each, kernel, block, shared_bytes),
          "cudaOccupancyMaxActiveBlocksPerMultiprocessor");
    return std::max(1, each) * device.multiProcessorCount;
}

// What one multiprocessor has, and what one block of a kernel takes of it.
struct MultiprocessorLimits {
    int threads, blocks, registers, shared_bytes;
};
struct BlockNeeds {
    int threads, registers_per_thread, shared_bytes;
};

// Blocks that fit: the scarcest resource decides. (The hardware deals registers and shared memory
// out in chunks; cudaOccupancy... knows their sizes.)
inline int blocks_that_fit(const MultiprocessorLimits& has, const BlockNeeds& needs) {
    // Steps:
    // 1. How many do the places for blocks and for threads allow?
    // 2. How many do the registers allow? A block takes them for each of its threads; 0 is no
    //    limit.
    // 3. How many does shared memory allow? 0 is no limit.
    // 4. Return the least.
    //[ task 3.6
    int fit = std::min(has.blocks, has.threads / needs.threads);
    if (needs.registers_per_thread > 0)
        fit = std::min(fit, has.registers / (needs.registers_per_thread * needs.threads));
    if (needs.shared_bytes > 0) fit = std::min(fit, has.shared_bytes / needs.shared_bytes);
    return fit;
    //| not_implemented("3.6", "blocks_that_fit()");
    //| return 1;
    //]
}

} // namespace raylab::lab03
