// Lab 01: threads over tiles, one recursion a pixel and iteration.
#include "labs/01_recursive/renderer.h"

#include "common/scene/set_camera.h"
#include "common/transport/emission.h"
#include "labs/01_recursive/camera.h"
#include "labs/01_recursive/threads.h"
#include "labs/01_recursive/tracer.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <thread>

namespace raylab::lab01 {

namespace {

constexpr int tile_size = 16; // pixels a side: enough work to share out, small enough to balance

// Room for one call of trace_path, ample also under sanitizers: paths of 10,000 surfaces are
// tested.
constexpr std::size_t stack_bytes_per_bounce = 8 << 10;
constexpr std::size_t stack_bytes_base = 1 << 20;

class RecursiveRenderer final : public Renderer {
  public:
    RecursiveRenderer(const Scene& scene, const MachineSettings& machine)
        : scene_(scene), view_(view(scene)), settings_(scene.render),
          film_(scene.camera.width, scene.camera.height),
          records_(machine.records ? film_.pixels.size() : 0),
          threads_(machine.threads > 0 ? machine.threads
                                       : static_cast<int>(std::thread::hardware_concurrency())),
          ledger_(empty_ledger()) {}

    void add_iteration() override {
        const auto start = std::chrono::steady_clock::now();
        const int columns = (film_.width + tile_size - 1) / tile_size;
        const int tiles = columns * ((film_.height + tile_size - 1) / tile_size);
        std::atomic<int> next_tile = 0;
        const std::size_t stack = stack_bytes_base + stack_bytes_per_bounce * settings_.max_depth;

        run_on_threads(std::min(threads_, tiles), stack, [&] {
            Ledger counts; // each thread counts for itself; the counts are added up at the end
            for (int tile = next_tile++; tile < tiles; tile = next_tile++)
                render_tile(tile % columns * tile_size, tile / columns * tile_size, counts);
            add_counts(counts);
        });
        ++ledger_.samples;
        ledger_.seconds +=
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }

    void restart(const Camera& camera, std::uint32_t seed) override {
        set_camera(view_, camera);
        settings_.seed = seed;
        std::fill(film_.pixels.begin(), film_.pixels.end(), FilmPixel{});
        ledger_ = empty_ledger();
    }

    Film film(int first_row, int rows) const override {
        Film strip(film_.width, std::min(rows, film_.height - first_row));
        std::copy_n(film_.pixels.begin() + std::ptrdiff_t{first_row} * film_.width,
                    strip.pixels.size(), strip.pixels.begin());
        return strip;
    }
    std::vector<PathRecord> records() const override { return records_; }
    Ledger ledger() const override { return ledger_; }

  private:
    Ledger empty_ledger() const {
        return begin_ledger(scene_, view_.camera, "01_recursive",
                            fmt::format("host, {} threads", threads_));
    }

    void render_tile(int x0, int y0, Ledger& counts) {
        for (int y = y0; y < std::min(y0 + tile_size, film_.height); ++y)
            for (int x = x0; x < std::min(x0 + tile_size, film_.width); ++x) {
                const int pixel = y * film_.width + x;
                PathRecord record;
                add_sample(film_.pixels[pixel], trace_pixel(x, y, pixel, record));
                count(record, counts);
                if (!records_.empty()) records_[pixel] = record;
            }
    }

    // One sample of one pixel. The random numbers are keyed by pixel and sample, never by thread.
    Vec3 trace_pixel(int x, int y, int pixel, PathRecord& record) const {
        const Sampler sampler = {settings_.sampler, settings_.seed,
                                 static_cast<std::uint32_t>(pixel),
                                 static_cast<std::uint32_t>(ledger_.samples)};
        const Ray ray = camera_ray(view_.camera, x, y, film_point(settings_.jitter, sampler),
                                   sampler.get_2d(dimension::lens));
        const Path path = {view_, settings_, sampler, record};
        return settings_.integrator == Integrator::path
                   ? trace_path(path, ray, 0, delta_pdf, Vec3(1))
                   : trace_whitted(path, ray, 0, 1);
    }

    // A path of length n was alive in bounces 0 to n - 1 and ended in the last.
    static void count(const PathRecord& record, Ledger& counts) {
        if (counts.bounces.size() < record.length) counts.bounces.resize(record.length);
        for (int bounce = 0; bounce < record.length; ++bounce) ++counts.bounces[bounce].rays;
        ++counts.bounces[record.length - 1].ended[static_cast<int>(record.end)];
        counts.shadow_rays += record.shadow_rays;
    }

    void add_counts(const Ledger& counts) {
        const std::lock_guard lock(mutex_);
        if (ledger_.bounces.size() < counts.bounces.size())
            ledger_.bounces.resize(counts.bounces.size());
        for (std::size_t b = 0; b < counts.bounces.size(); ++b) {
            ledger_.bounces[b].rays += counts.bounces[b].rays;
            for (int end = 0; end < path_ends; ++end)
                ledger_.bounces[b].ended[end] += counts.bounces[b].ended[end];
        }
        ledger_.shadow_rays += counts.shadow_rays;
    }

    const Scene& scene_;
    SceneView view_;          // its camera is the one of the last restart()
    RenderSettings settings_; // its seed is the one of the last restart()
    Film film_;
    std::vector<PathRecord> records_; // of the last iteration
    int threads_;
    Ledger ledger_;
    std::mutex mutex_;
};

} // namespace

MemoryUse memory_use(const Scene&, const MachineSettings& machine) {
    return {sizeof(FilmPixel) + (machine.records ? sizeof(PathRecord) : 0), 0};
}

std::unique_ptr<Renderer> make_renderer(const Scene& scene, const MachineSettings& machine) {
    return std::make_unique<RecursiveRenderer>(scene, machine);
}

} // namespace raylab::lab01
