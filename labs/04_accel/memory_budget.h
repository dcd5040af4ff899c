// How large a pool the memory allows.
//
// Scene, structure and film must fit as they are, the pool takes what is left: a smaller pool draws
// the same image in more batches. Below one warp it is refused.
#pragma once

#include "common/render/renderer.h"

namespace raylab::lab04 {

// What a structure and its building take for a triangle, beside the scene: 64 bytes (needles) to 90
// (terrain) were measured with `wide`.
constexpr std::size_t building_bytes_per_triangle = 128;

struct MemoryNeeds {
    std::size_t scene_bytes;     // all arrays of the scene
    std::size_t structure_bytes; // nodes and packs of triangles
    std::size_t film_bytes;      // a pixel each: sums, path record
    std::size_t slot_bytes;      // for each slot of the pool: path, branches, lists, scan
};

// Room for Whitted's pending rays: one on each level that can split. 0 for path tracing.
int branches_of(const RenderSettings& settings);

// Device memory for each slot of a pool of n: the path, its branches, three lists, the counts of
// its walk, and what compaction needs.
std::size_t slot_bytes(const Scene& scene, std::int64_t n);

// All that a pool of n takes. records: whether each pixel's is kept.
MemoryNeeds memory_needs(const Scene& scene, std::size_t structure_bytes, std::int64_t n,
                         bool records = true);

// Slots that fit into `budget` bytes, at most `wanted`. Throws SettingsError, with the figures,
// if there is not room for a warp.
int pool_that_fits(std::int64_t budget, const MemoryNeeds& needs, int wanted);

} // namespace raylab::lab04
