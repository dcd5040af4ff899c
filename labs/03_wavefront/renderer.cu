// Lab 03: a pool of rays, one launch a stage and bounce.
//
// "Parallelize by rays, not pixels! Instead of a single kernel launch that traces an entire ray
// path, do multiple kernel launches that trace individual bounces." trace_fill() is that slide.
#include "labs/03_wavefront/renderer.h"

#include "labs/03_wavefront/memory_budget.h"
#include "labs/03_wavefront/shared_geometry.h"
#include "labs/03_wavefront/wavefront.h"

#include <algorithm>
#include <chrono>

namespace raylab::lab03 {

namespace {

// Throws SettingsError where a cache is asked for and would be wrong.
void check_first_bounce_cache(const WavefrontSettings& settings, const Camera& camera,
                              const RenderSettings& render) {
    if (!settings.first_bounce_cache) return;
    if (const auto why_not = no_first_bounce_cache(camera, render))
        throw SettingsError("a first-bounce cache would be wrong here: " + *why_not);
}

class WavefrontRenderer final : public Renderer {
  public:
    WavefrontRenderer(const Scene& scene, const MachineSettings& machine, int pool_paths)
        : scene_(scene), machine_(machine), pixels_(scene.camera.width * scene.camera.height),
          pool_paths_(pool_paths), wavefront_(scene, machine, pool_paths) {}

    void add_iteration() override {
        const auto start = std::chrono::steady_clock::now();
        configure_machine(machine_);
        wavefront_.begin_sample(samples_);
        if (machine_.wavefront.regenerate)
            trace_all();
        else
            for (int first = 0; first < pixels_; first += pool_paths_)
                trace_fill(first, std::min(pool_paths_, pixels_ - first));
        check(cudaDeviceSynchronize(), "cudaDeviceSynchronize");
        ++samples_;
        seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }

    void restart(const Camera& camera, std::uint32_t seed) override {
        check_first_bounce_cache(machine_.wavefront, camera, scene_.render);
        wavefront_.restart(camera, seed);
        samples_ = 0;
        seconds_ = 0;
    }

    Film film(int first_row, int rows) const override {
        return wavefront_.results().film(scene_.camera, first_row, rows);
    }

    std::vector<PathRecord> records() const override { return wavefront_.results().records(); }

    Ledger ledger() const override {
        Ledger ledger = begin_ledger(scene_, wavefront_.camera(), "03_wavefront", machine_name());
        ledger.samples = static_cast<int>(samples_);
        ledger.seconds = seconds_;
        ledger.pool_paths = pool_paths_;
        ledger.path_bytes = static_cast<int>(slot_bytes(scene_, machine_.wavefront, pool_paths_));
        ledger.stages = wavefront_.stage_counts();
        for (const StageCounts& stage : ledger.stages) ledger.threads_launched += stage.threads;
        wavefront_.results().write_to(ledger);
        return ledger;
    }

  private:
    // The lecture's five steps, for the pixels first ... first + n - 1.
    void trace_fill(int first, int n) {
        wavefront_.generate(first,
                            n); // 1. A pool of rays to be tested. 2. Colours, unaccumulated yet.
        for (int bounce = 0; wavefront_.alive() > 0 && bounce < wavefront_.most_bounces();
             ++bounce) {
            wavefront_.intersect(bounce); // 3. ONE bounce of every ray,
            wavefront_.sort_by_material();
            wavefront_.shade();
            wavefront_.shadow();             //    and the next rays recorded in the pool.
            wavefront_.remove_ended(bounce); // 4. Terminated rays leave the pool.
        }                                    // 5. Repeat.
        wavefront_.accumulate(n);
    }

    // The same with *persistent paths*: a path that ends makes room for the next pixel's at once,
    // so that the pool stays full and there is nothing to remove until the pixels run out. Paths of
    // all bounces share a launch. Aila and Laine, Understanding the Efficiency of Ray Traversal on
    // GPUs, HPG 2009, section 3.3; Novak, Havran and Dachsbacher, Path Regeneration, 2010.
    void trace_all() {
        wavefront_.generate(0, pool_paths_);
        while (wavefront_.alive() > 0) {
            wavefront_.intersect(mixed_bounces);
            wavefront_.sort_by_material();
            wavefront_.shade();
            wavefront_.shadow();
            wavefront_.regenerate();
        }
    }

    const Scene& scene_;
    MachineSettings machine_;
    int pixels_, pool_paths_;
    Wavefront wavefront_;
    std::uint32_t samples_ = 0;
    double seconds_ = 0;
};

} // namespace

// The scene's copy in device memory counts, and the pool that there is room for.
MemoryUse memory_use(const Scene& scene, const MachineSettings& machine) {
    const int paths = wanted_paths(scene, machine.wavefront);
    const MemoryNeeds needs = memory_needs(scene, machine.wavefront, paths, machine.records);
    return raylab::memory_use(scene, needs, paths);
}

std::unique_ptr<Renderer> make_renderer(const Scene& scene, const MachineSettings& machine) {
    const WavefrontSettings& settings = machine.wavefront;
    const std::size_t geometry = geometry_bytes(view(scene));
    if (settings.shared_geometry && geometry > shared_memory_limit)
        throw SettingsError("the shapes of '" + scene.name + "' take " + std::to_string(geometry) +
                            " bytes, a block's shared memory has " +
                            std::to_string(shared_memory_limit) +
                            ": leave the geometry in global memory for this scene");

    check_first_bounce_cache(settings, scene.camera, scene.render);

    const int wanted = wanted_paths(scene, settings);
    const MemoryNeeds needs = memory_needs(scene, settings, wanted, machine.records);
    return std::make_unique<WavefrontRenderer>(scene, machine,
                                               pool_on_device(settings, needs, wanted));
}

} // namespace raylab::lab03
