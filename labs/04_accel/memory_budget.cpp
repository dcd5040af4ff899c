#include "labs/04_accel/memory_budget.h"

#include "common/scene/scene_arrays.h"
#include "common/wavefront/compact.h"
#include "labs/04_accel/leaf/query.h"
#include "labs/04_accel/pool.h"

namespace raylab::lab04 {

std::size_t slot_bytes(const Scene& scene, std::int64_t n) {
    constexpr std::size_t lists = 3;
    const std::size_t words = (Compaction::words(n) + n - 1) / n;
    return PoolView(branches_of(scene.render)).bytes_per_slot + 4 * (lists + words) +
           sizeof(WalkCounts);
}

MemoryNeeds memory_needs(const Scene& scene, std::size_t structure_bytes, std::int64_t n,
                         bool records) {
    return {.scene_bytes = scene_bytes(scene),
            .structure_bytes = structure_bytes,
            .film_bytes = film_bytes(scene, records),
            .slot_bytes = slot_bytes(scene, n)};
}

} // namespace raylab::lab04
