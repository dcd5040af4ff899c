#include "labs/04_accel/memory_budget.h"

#include "common/scene/scene_arrays.h"
#include "labs/04_accel/compact.h"
#include "labs/04_accel/leaf/query.h"
#include "labs/04_accel/pool.h"

#include <fmt/format.h>

#include <algorithm>

namespace raylab::lab04 {

int branches_of(const RenderSettings& settings) {
    return settings.integrator == Integrator::whitted ? std::max(1, settings.max_depth - 1) : 0;
}

std::size_t slot_bytes(const Scene& scene, std::int64_t n) {
    constexpr std::size_t lists = 3;
    const std::size_t words = (Compaction::words(n) + n - 1) / n;
    return path_bytes + branch_bytes(branches_of(scene.render)) + 4 * (lists + words) +
           sizeof(WalkCounts);
}

MemoryNeeds memory_needs(const Scene& scene, std::size_t structure_bytes, std::int64_t n,
                         bool records) {
    const std::size_t pixels = std::size_t{1} * scene.camera.width * scene.camera.height;
    return {scene_bytes(scene), structure_bytes,
            pixels * (sizeof(FilmPixel) + (records ? sizeof(PathRecord) : 0)),
            slot_bytes(scene, n)};
}

int pool_that_fits(std::int64_t budget, const MemoryNeeds& needs, int wanted) {
    constexpr int least = 32; // a warp: below that, threads idle from the start
    const auto mib = [](double bytes) { return bytes / (1 << 20); };
    const std::int64_t fixed =
        static_cast<std::int64_t>(needs.scene_bytes + needs.structure_bytes + needs.film_bytes);
    const std::int64_t slots = (budget - fixed) / static_cast<std::int64_t>(needs.slot_bytes);
    const int enough = std::min(wanted, least);
    if (budget < fixed || slots < enough)
        throw SettingsError(fmt::format(
            "the scene takes {:.2f} MiB, the structure over its triangles {:.2f} MiB, the film "
            "{:.2f} MiB and a pool of {} paths, the least, {:.2f} MiB at {} bytes a path: more "
            "than the {:.2f} MiB there are. Choose a larger --memory-budget, a smaller image, or "
            "--accel none.",
            mib(needs.scene_bytes), mib(needs.structure_bytes), mib(needs.film_bytes), enough,
            mib(enough * needs.slot_bytes), needs.slot_bytes, mib(budget)));
    return static_cast<int>(std::min<std::int64_t>(wanted, slots));
}

} // namespace raylab::lab04
