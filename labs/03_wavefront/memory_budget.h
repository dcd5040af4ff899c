// How large a pool the memory allows.
//
// "Single biggest constraint is memory": scene and film must fit as they are, the pool takes what
// is left, for a smaller pool draws the same image in more batches. Below one warp it is refused.
#pragma once

#include "common/render/renderer.h"
#include "labs/03_wavefront/queues.h"

#include <array>

namespace raylab::lab03 {

struct MemoryNeeds {
    std::size_t scene_bytes; // all arrays of the scene
    std::size_t film_bytes;  // a pixel each: sums, path record, first hit
    std::size_t slot_bytes;  // for each slot of the pool: path, branches, lists, scan
};

// Room for Whitted's pending rays: one on each level that can split. 0 for path tracing.
int branches_of(const RenderSettings& settings);

// Every material's kind, by number: with MaterialSort::queues each has a queue.
std::array<bool, material_kinds> kinds_in(const Scene& scene);

// Device memory for each slot of a pool of n: the path, its branches, three lists, the queues, and
// what compaction needs.
std::size_t slot_bytes(const Scene& scene, const WavefrontSettings& settings, std::int64_t n);

// All that a pool of n takes. records: whether each pixel's is kept.
MemoryNeeds memory_needs(const Scene& scene, const WavefrontSettings& settings, std::int64_t n,
                         bool records = true);

// Slots that fit into `budget` bytes, at most `wanted`. Throws SettingsError, with the figures,
// if there is not room for a warp.
int pool_that_fits(std::int64_t budget, const MemoryNeeds& needs, int wanted);

} // namespace raylab::lab03
