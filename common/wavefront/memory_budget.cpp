#include "common/wavefront/memory_budget.h"

#include "common/device/device_array.h"

#include <fmt/format.h>

#include <algorithm>

namespace raylab {

int branches_of(const RenderSettings& settings) {
    return settings.integrator == Integrator::whitted ? std::max(1, settings.max_depth - 1) : 0;
}

namespace {
std::size_t pixels_of(const Scene& scene) {
    return std::size_t{1} * scene.camera.width * scene.camera.height;
}
} // namespace

std::size_t film_bytes(const Scene& scene, bool records, std::size_t others) {
    return pixels_of(scene) * (sizeof(FilmPixel) + (records ? sizeof(PathRecord) : 0) + others);
}

int wanted_paths(const Scene& scene, const WavefrontSettings& settings) {
    return static_cast<int>(std::min<std::size_t>(settings.pool, pixels_of(scene)));
}

int pool_that_fits(std::int64_t budget, const MemoryNeeds& needs, int wanted) {
    constexpr int least = 32; // a warp: below that, threads idle from the start
    const std::int64_t fixed =
        static_cast<std::int64_t>(needs.scene_bytes + needs.structure_bytes + needs.film_bytes);
    const std::int64_t slots = (budget - fixed) / static_cast<std::int64_t>(needs.slot_bytes);
    const int enough = std::min(wanted, least);
    if (budget >= fixed && slots >= enough)
        return static_cast<int>(std::min<std::int64_t>(wanted, slots));
    const auto mib = [](double bytes) { return fmt::format("{:.2f} MiB", bytes / (1 << 20)); };
    const bool structure = needs.structure_bytes > 0;
    throw SettingsError(fmt::format(
        "the scene takes {}, {}the film {} and a pool of {} paths, the least, {} at {} bytes a "
        "path: more than the {} there are. Choose a larger --memory-budget{} a smaller image{}.",
        mib(needs.scene_bytes),
        structure ? "the structure over its triangles " + mib(needs.structure_bytes) + ", " : "",
        mib(needs.film_bytes), enough, mib(enough * needs.slot_bytes), needs.slot_bytes,
        mib(budget), structure ? "," : " or", structure ? ", or --accel none" : ""));
}

int pool_on_device(const WavefrontSettings& settings, const MemoryNeeds& needs, int wanted) {
    if (settings.memory_budget > 0) return pool_that_fits(settings.memory_budget, needs, wanted);
    cudaDeviceProp device{};
    check(cudaGetDeviceProperties(&device, 0), "cudaGetDeviceProperties");
    return pool_that_fits(static_cast<std::int64_t>(device.totalGlobalMem), needs, wanted);
}

MemoryUse memory_use(const Scene& scene, const MemoryNeeds& needs, int paths) {
    return {needs.film_bytes / pixels_of(scene),
            needs.scene_bytes + needs.structure_bytes + paths * needs.slot_bytes};
}

} // namespace raylab
