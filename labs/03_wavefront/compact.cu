// Compaction, by scan; see compact.h.
#include "labs/03_wavefront/compact.h"

#include "common/device/launch.h"
#include "common/task/not_implemented.h"
#include "common/wavefront/grid.h"

#include <stdexcept>
#include <string>

namespace raylab::lab03 {

namespace {

__global__ void flag_alive(const std::uint8_t* alive, const int* live, int n,
                           std::uint32_t* flags) {
    const std::int64_t i = global_index();
    if (i < n) flags[i] = alive[live[i]];
}

__global__ void flag_clear_bit(const std::uint8_t* key, int bit, const int* slots, int n,
                               std::uint32_t* flags) {
    const std::int64_t i = global_index();
    if (i < n) flags[i] = (key[slots[i]] >> bit & 1) == 0;
}

__global__ void scatter_kept(const int* live, int n, const std::uint32_t* flags,
                             const std::uint32_t* places, int* kept) {
    // Steps:
    // 1. Find the number i of this thread in the grid. A thread from n on has nothing to do.
    // 2. If slot i is flagged, write the slot to its place.
    //[ task 3.3
    const std::int64_t i = global_index();
    if (i < n && flags[i]) kept[places[i]] = live[i];
    //|
    //]
}

// Those before their place in the second group: all of the first, and those of i that were not.
__global__ void scatter_split(const int* slots, int n, const std::uint32_t* flags,
                              const std::uint32_t* places, int first_group, int* result) {
    // Steps:
    // 1. Find the number i of this thread in the grid. A thread from n on has nothing to do.
    // 2. A flagged slot: its place is that of the scan.
    // 3. Another: count those before i that are not flagged either; the first group goes before.
    //[ task 3.3
    const std::int64_t i = global_index();
    if (i >= n) return;
    const int place = static_cast<int>(places[i]);
    result[flags[i] ? place : first_group + static_cast<int>(i) - place] = slots[i];
    //|
    //]
}

// One thread a warp of the list.
__global__ void count_alive_kernel(const std::uint8_t* alive, const int* live, int n,
                                   Counters* counters) {
    const std::int64_t first = global_index() * warp_lanes;
    if (first >= n) return;
    int sum = 0;
    for (std::int64_t i = first; i < first + warp_lanes && i < n; ++i) sum += alive[live[i]];
    if (sum == 0) return;
    atomicAdd(&counters->alive, sum);
    atomicAdd(&counters->busy_warps, 1);
}

} // namespace

Compaction::Compaction(ScanKind scan, int capacity, int block_size)
    : scan_(scan_function(scan)), block_(block_size), flags_(capacity), places_(capacity),
      workspace_(scan_workspace(scan, capacity)) {}

std::int64_t Compaction::words(ScanKind scan, std::int64_t capacity) {
    return 2 * capacity + scan_workspace(scan, capacity);
}

int Compaction::scan_flags(int n) {
    scan_(flags_.data(), places_.data(), n, workspace_.data());
    std::uint32_t last[2] = {};
    check(cudaMemcpy(&last[0], flags_.data() + n - 1, sizeof last[0], cudaMemcpyDeviceToHost),
          "the last flag");
    check(cudaMemcpy(&last[1], places_.data() + n - 1, sizeof last[1], cudaMemcpyDeviceToHost),
          "the last place");
    const std::uint32_t sum = last[0] + last[1];
    if (sum > static_cast<std::uint32_t>(n))
        throw std::runtime_error("the scan of " + std::to_string(n) +
                                 " flags, each 0 or 1, gives " + std::to_string(sum) +
                                 ": the scan is wrong");
    return static_cast<int>(sum);
}

int Compaction::keep_alive(const std::uint8_t* alive, const int* live, int n, int* kept) {
    if (n == 0) return 0;
    // Steps:
    // 1. Flag the slots that are alive, a thread each.
    // 2. Scan the flags: places, and how many there are.
    // 3. Scatter the flagged slots, check the launches, return how many.
    //[ task 3.3
    const int blocks = blocks_for(n, block_);
    flag_alive<<<blocks, block_>>>(alive, live, n, flags_.data());
    const int count = scan_flags(n);
    scatter_kept<<<blocks, block_>>>(live, n, flags_.data(), places_.data(), kept);
    check(cudaGetLastError(), "compaction");
    return count;
    //| // Nothing is removed: a slower, legal wavefront. Ended paths are skipped by every stage.
    //| not_implemented("3.3", "Compaction::keep_alive()");
    //| check(cudaMemcpy(kept, live, n * sizeof(int), cudaMemcpyDeviceToDevice), "copying the list");
    //| return n;
    //]
}

void Compaction::split_by_bit(const std::uint8_t* key, int bit, const int* slots, int n,
                              int* result) {
    if (n == 0) return;
    // Steps:
    // 1. Flag the slots whose bit is clear, a thread each.
    // 2. Scan the flags: places, and the size of the first group.
    // 3. Scatter both groups, and check the launches.
    //[ task 3.3
    const int blocks = blocks_for(n, block_);
    flag_clear_bit<<<blocks, block_>>>(key, bit, slots, n, flags_.data());
    const int first_group = scan_flags(n);
    scatter_split<<<blocks, block_>>>(slots, n, flags_.data(), places_.data(), first_group, result);
    check(cudaGetLastError(), "split by bit");
    //| not_implemented("3.3", "Compaction::split_by_bit()");
    //| check(cudaMemcpy(result, slots, n * sizeof(int), cudaMemcpyDeviceToDevice), "copying the list");
    //]
}

void Compaction::count_alive(const std::uint8_t* alive, const int* live, int n,
                             Counters* counters) {
    const int warps = warps_for(n);
    count_alive_kernel<<<blocks_for(warps, block_), block_>>>(alive, live, n, counters);
    check(cudaGetLastError(), "count_alive_kernel");
}

} // namespace raylab::lab03
