#include "app/bench_lab.h"

#include "common/render/render.h"

#if !defined(RAYLAB_CUDA)
#include "common/simt/options.h"
#endif

#include <chrono>

#if defined(__APPLE__)
#include <malloc/malloc.h>
#else
#include <malloc.h>
#endif

namespace raylab::app {

namespace {

// Of the heap, and of the CPU machine's device memory.
double bytes_in_use() {
    double device = 0;
#if !defined(RAYLAB_CUDA)
    device = static_cast<double>(simt::mapped_bytes());
#endif
#if defined(__APPLE__)
    malloc_statistics_t info{};
    malloc_zone_statistics(nullptr, &info); // of all zones
    return device + static_cast<double>(info.size_in_use);
#else
    const struct mallinfo2 info = mallinfo2();
    return device + static_cast<double>(info.uordblks) + static_cast<double>(info.hblkhd);
#endif
}

} // namespace

bench::Contestant lab_contestant(const Lab& lab, const Scene& scene,
                                 const MachineSettings& machine) {
    const auto render = [&lab, &scene, machine](int spp, std::uint32_t seed) {
        bench::Drawn drawn;
        const double bytes_before = bytes_in_use();
        const auto start = std::chrono::steady_clock::now();
        const std::unique_ptr<Renderer> renderer = lab.make(scene, machine);
        Render finished = raylab::render(*renderer, scene, scene.camera, seed, spp);
        drawn.seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        drawn.bytes = bytes_in_use() - bytes_before;
        drawn.image = std::move(finished.image);
        drawn.ledger = std::move(finished.ledger);
        return drawn;
    };
    return {lab.number, lab.folder, render};
}

} // namespace raylab::app
