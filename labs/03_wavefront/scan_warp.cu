// A scan by warp shuffles; see warp_scan.h.
//
// Three levels: each thread adds up its neighbours, each warp scans its threads' sums in registers,
// and the first warp scans the warps' sums. Two barriers a tile instead of sixteen.
#include "common/device/device_array.h"
#include "common/wavefront/grid.h"
#include "labs/03_wavefront/scan_tiles.h"
#include "labs/03_wavefront/warp_scan.h"

namespace raylab::lab03 {

namespace {

constexpr int warps = tile_threads / 32;

__global__ void warp_kernel(const std::uint32_t* in, std::uint32_t* out, std::int64_t n,
                            std::uint32_t* sums) {
    __shared__ std::uint32_t warp_sums[warps];
    const int t = static_cast<int>(threadIdx.x), warp = t / 32, lane = t % 32;
    const std::int64_t first = global_index() * thread_items;
    std::uint32_t items[thread_items];
    const std::uint32_t own = load_items(in, n, first, items);

    const std::uint32_t upto = warp_inclusive_scan(own);
    if (lane == 31) warp_sums[warp] = upto;
    __syncthreads();
    if (warp == 0) {
        const std::uint32_t scanned = warp_inclusive_scan(lane < warps ? warp_sums[lane] : 0);
        if (lane < warps) warp_sums[lane] = scanned;
    }
    __syncthreads();
    const std::uint32_t before_warp = warp == 0 ? 0 : warp_sums[warp - 1];
    store_scanned(out, n, first, items, before_warp + upto - own);
    if (t == tile_threads - 1) sums[blockIdx.x] = before_warp + upto;
}

} // namespace

void scan_warp(const std::uint32_t* in, std::uint32_t* out, std::int64_t n,
               std::uint32_t* workspace) {
    scan_by_tiles(warp_kernel, in, out, n, workspace);
}

} // namespace raylab::lab03
