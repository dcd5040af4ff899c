#include "labs/03_wavefront/memory_budget.h"

#include "common/scene/scene_arrays.h"
#include "labs/03_wavefront/compact.h"
#include "labs/03_wavefront/pool.h"

namespace raylab::lab03 {

std::array<bool, material_kinds> kinds_in(const Scene& scene) {
    std::array<bool, material_kinds> present{};
    for (const Material& material : scene.materials)
        present[static_cast<int>(material.kind)] = true;
    return present;
}

std::size_t slot_bytes(const Scene& scene, const WavefrontSettings& settings, std::int64_t n) {
    std::size_t lists = 3;
    if (settings.sort == MaterialSort::queues)
        for (const bool present : kinds_in(scene)) lists += present;
    const std::size_t words = (Compaction::words(settings.scan, n) + n - 1) / n;
    return PoolView(branches_of(scene.render)).bytes_per_slot + 4 * (lists + words);
}

MemoryNeeds memory_needs(const Scene& scene, const WavefrontSettings& settings, std::int64_t n,
                         bool records) {
    const std::size_t cache = settings.first_bounce_cache ? sizeof(Hit) : 0;
    return {.scene_bytes = scene_bytes(scene),
            .film_bytes = film_bytes(scene, records, cache),
            .slot_bytes = slot_bytes(scene, settings, n)};
}

} // namespace raylab::lab03
