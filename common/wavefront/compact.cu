#include "common/wavefront/compact.h"

#include "common/device/launch.h"
#include "common/wavefront/grid.h"
#include "common/wavefront/scan_library.h"

namespace raylab {

namespace {

__global__ void flag_alive(const std::uint8_t* alive, const int* live, int n,
                           std::uint32_t* flags) {
    const std::int64_t i = global_index();
    if (i < n) flags[i] = alive[live[i]];
}

__global__ void scatter_kept(const int* live, int n, const std::uint32_t* flags,
                             const std::uint32_t* places, int* kept) {
    const std::int64_t i = global_index();
    if (i < n && flags[i]) kept[places[i]] = live[i];
}

} // namespace

Compaction::Compaction(int capacity, int block_size)
    : block_(block_size), flags_(capacity), places_(capacity),
      workspace_(scan_library_workspace(capacity)) {}

std::int64_t Compaction::words(std::int64_t capacity) {
    return 2 * capacity + scan_library_workspace(capacity);
}

int Compaction::keep_alive(const std::uint8_t* alive, const int* live, int n, int* kept) {
    if (n == 0) return 0;
    const int blocks = blocks_for(n, block_);
    flag_alive<<<blocks, block_>>>(alive, live, n, flags_.data());
    scan_library(flags_.data(), places_.data(), n, workspace_.data());
    scatter_kept<<<blocks, block_>>>(live, n, flags_.data(), places_.data(), kept);
    check(cudaGetLastError(), "compaction");
    std::uint32_t last[2] = {}; // the last flag, and the sum of those before
    check(cudaMemcpy(&last[0], flags_.data() + n - 1, sizeof last[0], cudaMemcpyDeviceToHost),
          "the last flag");
    check(cudaMemcpy(&last[1], places_.data() + n - 1, sizeof last[1], cudaMemcpyDeviceToHost),
          "the last place");
    return static_cast<int>(last[0] + last[1]);
}

} // namespace raylab
