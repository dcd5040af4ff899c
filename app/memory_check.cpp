#include "app/memory_check.h"

#include "common/image/image.h"

#include <fmt/format.h>

#include <cmath>
#include <thread>

namespace raylab::app {

namespace {

constexpr std::uint64_t image_bytes = 2 * sizeof(Vec3); // mean and standard error
constexpr std::uint64_t file_bytes = 3 * sizeof(Vec3);  // variance; noise, which does not compress
constexpr std::uint64_t program_bytes = 24 << 20;       // code, buffers of libraries
constexpr std::uint64_t stack_bytes = 8 << 20; // of a thread: reserved, which `ulimit -v` counts

// The largest film of the same shape, or nothing.
std::string what_fits(const MemoryNeed& need, std::uint64_t available) {
    if (available <= need.fixed_bytes) return "";
    const double pixels = double(available - need.fixed_bytes) / double(need.pixel_bytes);
    const double scale = std::sqrt(pixels / (double(need.width) * need.height));
    const int width = int(scale * need.width), height = int(scale * need.height);
    return width < 1 || height < 1 ? "" : fmt::format("--width {} --height {}", width, height);
}

} // namespace

MemoryNeed memory_need(const Lab& lab, const Scene& scene, const MachineSettings& machine) {
    const MemoryUse use = lab.memory(scene, machine);
    const std::uint64_t workers =
        machine.threads > 0 ? machine.threads : std::thread::hardware_concurrency();
    const std::uint64_t threads = workers + 1; // + the one that renders (kept_render.h)
    return {scene.camera.width, scene.camera.height, use.pixel + image_bytes + file_bytes,
            use.fixed + program_bytes + threads * stack_bytes};
}

std::string to_sentence(const MemoryNeed& need, const AvailableMemory& available) {
    return fmt::format("takes up to {} of memory, {} bytes a pixel; {} are available",
                       human_bytes(double(need.total())), need.pixel_bytes,
                       human_bytes(double(available.bytes)));
}

void check_memory(const MemoryNeed& need, const AvailableMemory& available) {
    if (need.total() <= available.bytes) return;
    const std::string fits = what_fits(need, available.bytes);
    throw UsageError(fmt::format(
        "a film of {} x {} pixels {} ({}): {}", need.width, need.height,
        to_sentence(need, available), available.limit,
        fits.empty() ? fmt::format("even without a film it takes {}: free some memory, choose a "
                                   "smaller --pool (labs 03 and 04) or a scene of fewer triangles",
                                   human_bytes(double(need.fixed_bytes)))
                     : fits + " would fit"));
}

} // namespace raylab::app
