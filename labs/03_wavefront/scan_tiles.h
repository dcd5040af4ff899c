// A scan of any length from a scan of one tile: what one block can do at a time.
//
//     1. each block scans its tile and writes the tile's sum;
//     2. the sums of the tiles are scanned, by the same means, level by level until one tile is
//     left;
//     3. each element gets the sum of all tiles before its own added.
// GPU Gems 3, section 39.2.4. For the memory that is: read n, write n, read n, write n, twice the
// traffic of a copy.
#pragma once

#include "common/simt/cuda.h"
#include "labs/03_wavefront/scan.h"

namespace raylab::lab03 {

constexpr int tile_threads = 128;
constexpr int thread_items = 8; // neighbours that a thread adds up by itself
constexpr int tile_items = tile_threads * thread_items;

constexpr std::int64_t tiles_for(std::int64_t n) { return (n + tile_items - 1) / tile_items; }

// Sums of all levels: n / 1024 + n / 1024^2 + ...
constexpr std::int64_t tiled_workspace(std::int64_t n) {
    std::int64_t words = 0;
    do words += 2 * (n = tiles_for(n));
    while (n > 1);
    return words;
}

// A kernel of tile_threads threads a block. sums[b]: the sum of tile b.
using TileKernel = void(const std::uint32_t* in, std::uint32_t* out, std::int64_t n,
                        std::uint32_t* sums);

void scan_by_tiles(TileKernel* kernel, const std::uint32_t* in, std::uint32_t* out, std::int64_t n,
                   std::uint32_t* workspace);

// The thread's neighbours, zero beyond the end; returns their sum. first: index of the first.
__device__ inline std::uint32_t load_items(const std::uint32_t* in, std::int64_t n,
                                           std::int64_t first, std::uint32_t* items) {
    std::uint32_t sum = 0;
    for (int k = 0; k < thread_items; ++k) {
        items[k] = first + k < n ? in[first + k] : 0;
        sum += items[k];
    }
    return sum;
}

// Writes the scan of the thread's neighbours, all of them after `before`.
__device__ inline void store_scanned(std::uint32_t* out, std::int64_t n, std::int64_t first,
                                     const std::uint32_t* items, std::uint32_t before) {
    for (int k = 0; k < thread_items; ++k) {
        if (first + k < n) out[first + k] = before;
        before += items[k];
    }
}

} // namespace raylab::lab03
