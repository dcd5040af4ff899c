// Launching a scan tile by tile; see scan_tiles.h.
#include "common/wavefront/grid.h"
#include "labs/03_wavefront/scan_tiles.h"

#include "common/device/device_array.h"

namespace raylab::lab03 {

namespace {

__global__ void add_sums(std::uint32_t* out, std::int64_t n, const std::uint32_t* sums_before) {
    const std::int64_t first = global_index() * thread_items;
    for (int k = 0; k < thread_items; ++k)
        if (first + k < n) out[first + k] += sums_before[blockIdx.x];
}

} // namespace

void scan_by_tiles(TileKernel* kernel, const std::uint32_t* in, std::uint32_t* out, std::int64_t n,
                   std::uint32_t* workspace) {
    if (n == 0) return;
    const std::int64_t tiles = tiles_for(n);
    std::uint32_t* sums = workspace;
    std::uint32_t* sums_before = workspace + tiles;
    kernel<<<static_cast<unsigned>(tiles), tile_threads>>>(in, out, n, sums);
    check(cudaGetLastError(), "scan of tiles");
    if (tiles == 1) return;
    scan_by_tiles(kernel, sums, sums_before, tiles, workspace + 2 * tiles);
    add_sums<<<static_cast<unsigned>(tiles), tile_threads>>>(out, n, sums_before);
    check(cudaGetLastError(), "add_sums");
}

} // namespace raylab::lab03
