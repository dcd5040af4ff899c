// Lab 04: the wavefront of lab 03, whose rays no longer test every triangle.
//
// trace_fill() is lab 03's loop with one stage more: rays walk through a structure over the
// triangles, and through another over spheres and quads where there are many, before they meet the
// other shapes, and so do shadow rays.
#include "labs/04_accel/renderer.h"

#include "labs/04_accel/endless_walk.h"
#include "labs/04_accel/memory_budget.h"
#include "labs/04_accel/wavefront.h"

#include <algorithm>
#include <chrono>

namespace raylab::lab04 {

namespace {

class AccelRenderer final : public Renderer {
  public:
    AccelRenderer(const Scene& scene, const MachineSettings& machine, Accel accel, int pool_paths)
        : scene_(scene), machine_(machine), pixels_(scene.camera.width * scene.camera.height),
          pool_paths_(pool_paths), wavefront_(scene, machine, std::move(accel), pool_paths) {}

    void add_iteration() override {
        const auto start = std::chrono::steady_clock::now();
        configure_machine(machine_);
        wavefront_.begin_sample(samples_);
        for (int first = 0; first < pixels_; first += pool_paths_)
            trace_fill(first, std::min(pool_paths_, pixels_ - first));
        const EndlessRay endless = wavefront_.endless_ray(); // waits for the device
        if (endless.found)
            throw endless_walk(endless, scene_.camera.width, samples_, wavefront_.accel().facts());
        ++samples_;
        seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }

    void restart(const Camera& camera, std::uint32_t seed) override {
        wavefront_.restart(camera, seed);
        samples_ = 0;
        seconds_ = 0;
    }

    Film film(int first_row, int rows) const override {
        return wavefront_.results().film(scene_.camera, first_row, rows);
    }

    std::vector<PathRecord> records() const override { return wavefront_.results().records(); }

    Ledger ledger() const override {
        Ledger ledger = begin_ledger(scene_, wavefront_.camera(), "04_accel", machine_name());
        ledger.samples = static_cast<int>(samples_);
        ledger.seconds = seconds_;
        ledger.pool_paths = pool_paths_;
        ledger.path_bytes = static_cast<int>(slot_bytes(scene_, pool_paths_));
        ledger.stages = wavefront_.stage_counts();
        for (const StageCounts& stage : ledger.stages) ledger.threads_launched += stage.threads;
        if (wavefront_.accel().has_triangles()) ledger.structure = wavefront_.accel().facts();
        if (wavefront_.accel().has_shape_tree()) ledger.shapes = wavefront_.accel().shape_facts();
        wavefront_.results().write_to(ledger);
        wavefront_.walks().write_to(ledger);
        return ledger;
    }

  private:
    // The lecture's five steps, for the pixels first ... first + n - 1.
    void trace_fill(int first, int n) {
        wavefront_.generate(first,
                            n); // 1. A pool of rays to be tested. 2. Colours, unaccumulated yet.
        for (int bounce = 0; wavefront_.alive() > 0 && bounce < wavefront_.most_bounces();
             ++bounce) {
            wavefront_.walk(bounce); // 3. ONE bounce of every ray, through the triangles,
            wavefront_.intersect();  //    past the other shapes,
            wavefront_.shade();
            wavefront_.trace_shadow_rays();  //    and the next rays recorded in the pool.
            wavefront_.remove_ended(bounce); // 4. Terminated rays leave the pool.
        }                                    // 5. Repeat.
        wavefront_.accumulate(n);
    }

    const Scene& scene_;
    MachineSettings machine_;
    int pixels_, pool_paths_;
    Wavefront wavefront_;
    std::uint32_t samples_ = 0;
    double seconds_ = 0;
};

} // namespace

std::vector<AccelSettings> accels() {
    std::vector<AccelSettings> all;
    for (const KnownWalk& known : known_walks()) all.push_back({known.accel, known.walk});
    return all;
}

MemoryUse memory_use(const Scene& scene, const MachineSettings& machine) {
    const int paths = wanted_paths(scene, machine.wavefront);
    const std::size_t structure = building_bytes_per_triangle * scene.triangles.size();
    const MemoryNeeds needs = memory_needs(scene, structure, paths, machine.records);
    return raylab::memory_use(scene, needs, paths);
}

std::unique_ptr<Renderer> make_renderer(const Scene& scene, const MachineSettings& machine,
                                        Accel accel) {
    const int wanted = wanted_paths(scene, machine.wavefront);
    const MemoryNeeds needs = memory_needs(scene, accel.bytes(), wanted, machine.records);
    const int pool = pool_on_device(machine.wavefront, needs, wanted);
    return std::make_unique<AccelRenderer>(scene, machine, std::move(accel), pool);
}

std::unique_ptr<Renderer> make_renderer(const Scene& scene, const MachineSettings& machine) {
    configure_machine(machine); // kernels build, too
    return make_renderer(scene, machine, Accel(scene, machine));
}

} // namespace raylab::lab04
