// What a pool takes of the device's memory; common/wavefront/memory_budget.h says what fits.
#pragma once

#include "common/wavefront/memory_budget.h"

namespace raylab::lab04 {

// What a structure and its building take for a triangle, beside the scene: 64 bytes (needles) to 90
// (terrain) were measured with `wide`.
constexpr std::size_t building_bytes_per_triangle = 128;

// Device memory for each slot of a pool of n: the path, its branches, three lists, the counts of
// its walk, and what compaction needs.
std::size_t slot_bytes(const Scene& scene, std::int64_t n);

// All that a pool of n takes. records: whether each pixel's is kept.
MemoryNeeds memory_needs(const Scene& scene, std::size_t structure_bytes, std::int64_t n,
                         bool records = true);

} // namespace raylab::lab04
