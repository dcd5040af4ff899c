// What a pool takes of the device's memory; common/wavefront/memory_budget.h says what fits.
#pragma once

#include "common/wavefront/memory_budget.h"
#include "labs/03_wavefront/queues.h"

#include <array>

namespace raylab::lab03 {

// Every material's kind, by number: with MaterialSort::queues each has a queue.
std::array<bool, material_kinds> kinds_in(const Scene& scene);

// Device memory for each slot of a pool of n: the path, its branches, three lists, the queues, and
// what compaction needs.
std::size_t slot_bytes(const Scene& scene, const WavefrontSettings& settings, std::int64_t n);

// All that a pool of n takes. records: whether each pixel's is kept.
MemoryNeeds memory_needs(const Scene& scene, const WavefrontSettings& settings, std::int64_t n,
                         bool records = true);

} // namespace raylab::lab03
