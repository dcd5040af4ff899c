// Lab 02: one CUDA thread a pixel, one launch an iteration.
#include "labs/02_iterative/renderer.h"

#include "common/device/device_scene.h"
#include "common/device/launch.h"
#include "common/scene/scene_features.h"
#include "common/scene/variants.h"
#include "labs/02_iterative/path.h"
#include "labs/02_iterative/wasted_cycles.h"
#include "labs/02_iterative/whitted.h"

#include <algorithm>
#include <chrono>

namespace raylab::lab02 {

namespace {

// The data that all threads of an iteration read.
struct Iteration {
    RenderSettings settings;
    std::uint32_t sample; // index of the sample that this iteration adds to every pixel
};

// The number of this thread's pixel, counted row by row; -1 if the thread has no pixel.
__device__ int pixel_of_thread(int pixels) {
    //[ task 2.2
    const int thread = static_cast<int>(blockIdx.x * blockDim.x + threadIdx.x);
    return thread < pixels ? thread : -1; // the last block overhangs the image
    //| not_implemented("2.2", "pixel_of_thread()");
    //| return -1;
    //]
}

// The random numbers of a path: keyed by pixel and sample, never by thread, so that the launch may
// be cut into blocks in any way.
HD Sampler sampler_of_path(const Iteration& iteration, int pixel) {
    //[ task 2.4
    const RenderSettings& settings = iteration.settings;
    return {settings.sampler, settings.seed, static_cast<std::uint32_t>(pixel), iteration.sample};
    //| not_implemented("2.4", "sampler_of_path()");
    //| return {};
    //]
}

// One thread: one pixel, one camera ray, one path.
template <Features F, Integrator I>
__global__ void trace_kernel(SceneView scene, Iteration iteration, FilmPixel* film,
                             PathRecord* records) {
    const Camera& camera = scene.camera;
    const int pixel = pixel_of_thread(camera.width * camera.height);
    if (pixel < 0) return;

    const RenderSettings& settings = iteration.settings;
    const Sampler sampler = sampler_of_path(iteration, pixel);
    const Vec2 u_film = film_point(settings.jitter, sampler);
    const Vec2 u_lens = F & feature::lens ? sampler.get_2d(dimension::lens) : Vec2(0);
    const Ray ray =
        generate_ray(camera, pixel % camera.width, pixel / camera.width, u_film, u_lens);

    PathRecord record;
    Vec3 radiance;
    if constexpr (I == Integrator::path)
        radiance = trace_path<F>(scene, settings, sampler, ray, record);
    else
        radiance = trace_whitted<F>(scene, settings, sampler, ray, record);
    //[ task 2.3
    add_sample(film[pixel], radiance);
    records[pixel] = record;
    //| not_implemented("2.3", "trace_kernel()");
    //]
}

class IterativeRenderer final : public Renderer {
  public:
    IterativeRenderer(const Scene& scene, const MachineSettings& machine)
        : host_scene_(scene), machine_(machine), features_(features_of(scene)), scene_(scene),
          settings_(scene.render), pixels_(scene.camera.width * scene.camera.height),
          film_(pixels_), records_(pixels_),
          max_bounces_(scene.render.integrator == Integrator::path ? scene.render.max_depth : 64),
          tallies_(static_cast<std::size_t>(shards) * max_bounces_), shadow_rays_(shards) {}

    void add_iteration() override {
        const auto start = std::chrono::steady_clock::now();
        configure_machine(machine_);
        const Iteration iteration = {settings_, samples_};
        const int block = machine_.block_size;
        with_variant(features_, [&]<Features F>() {
            const auto kernel = iteration.settings.integrator == Integrator::path
                                    ? trace_kernel<F, Integrator::path>
                                    : trace_kernel<F, Integrator::whitted>;
            //[ task 2.2
            const int blocks = blocks_for(pixels_, block);
            kernel<<<blocks, block>>>(scene_.view(), iteration, film_.data(), records_.data());
            //| not_implemented("2.2", "add_iteration()");
            //]
        });
        check(cudaGetLastError(), "trace_kernel launch");
        const int warps = warps_for(pixels_);
        count_wasted_cycles<<<blocks_for(warps, block), block>>>(
            records_.data(), pixels_, max_bounces_, tallies_.data(), shadow_rays_.data());
        check(cudaGetLastError(), "count_wasted_cycles launch");
        check(cudaDeviceSynchronize(), "cudaDeviceSynchronize");
        ++samples_;
        seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }

    void restart(const Camera& camera, std::uint32_t seed) override {
        scene_.set_camera(camera);
        features_ = features_of(host_scene_, camera);
        settings_.seed = seed;
        film_.clear();
        tallies_.clear();
        shadow_rays_.clear();
        samples_ = 0;
        seconds_ = 0;
    }

    Film film(int first_row, int rows) const override {
        const Camera& camera = host_scene_.camera;
        Film strip(camera.width, std::min(rows, camera.height - first_row));
        film_.to_host(std::size_t{1} * first_row * camera.width, strip.pixels);
        return strip;
    }

    std::vector<PathRecord> records() const override { return records_.to_host(); }

    Ledger ledger() const override;

  private:
    const Scene& host_scene_;
    MachineSettings machine_;
    Features features_;
    DeviceScene scene_;       // its camera is the one of the last restart()
    RenderSettings settings_; // its seed is the one of the last restart()
    int pixels_;
    DeviceArray<FilmPixel> film_;
    DeviceArray<PathRecord> records_;
    int max_bounces_;
    DeviceArray<BounceTally> tallies_;
    DeviceArray<unsigned long long> shadow_rays_;
    std::uint32_t samples_ = 0;
    double seconds_ = 0;
};

// The shards are added up; a path that ended in bounce b was alive in bounces 0 to b, so rays and
// lanes are sums over the bounces that follow.
Ledger IterativeRenderer::ledger() const {
    Ledger ledger = begin_ledger(host_scene_, scene_.view().camera, "02_iterative", machine_name());
    ledger.samples = static_cast<int>(samples_);
    ledger.seconds = seconds_;
    const int block = machine_.block_size;
    const std::uint64_t warps = warps_for(pixels_);
    ledger.threads_launched =
        std::uint64_t{samples_} * block * (blocks_for(pixels_, block) + blocks_for(warps, block));

    const std::vector<BounceTally> tallies = tallies_.to_host();
    ledger.bounces.resize(max_bounces_);
    std::uint64_t rays = 0, warps_busy = 0;
    for (int bounce = max_bounces_ - 1; bounce >= 0; --bounce) {
        BounceCounts& counts = ledger.bounces[bounce];
        for (int shard = 0; shard < shards; ++shard) {
            const BounceTally& tally =
                tallies[static_cast<std::size_t>(shard) * max_bounces_ + bounce];
            for (int end = 0; end < path_ends; ++end) {
                counts.ended[end] += tally.ended[end];
                rays += tally.ended[end];
            }
            warps_busy += tally.warps_ended;
        }
        counts.rays = rays;
        counts.lanes = warps_busy * warp_lanes;
    }
    for (const unsigned long long count : shadow_rays_.to_host()) ledger.shadow_rays += count;
    return ledger;
}

} // namespace

MemoryUse memory_use(const Scene&, const MachineSettings&) {
    return {sizeof(FilmPixel) + sizeof(PathRecord), 0}; // wasted cycles are counted from records
}

std::unique_ptr<Renderer> make_renderer(const Scene& scene, const MachineSettings& machine) {
    return std::make_unique<IterativeRenderer>(scene, machine);
}

} // namespace raylab::lab02
