// Lab 03: a pool of rays, one launch a stage and bounce.
//
// "Parallelize by rays, not pixels! Instead of a single kernel launch that traces an entire ray
// path, do multiple kernel launches that trace individual bounces." trace_batch() is that slide.
#include "labs/03_wavefront/renderer.h"

#include "common/device/device_scene.h"
#include "labs/03_wavefront/compact.h"
#include "labs/03_wavefront/kernels.h"
#include "labs/03_wavefront/launch_sizing.h"
#include "labs/03_wavefront/memory_budget.h"
#include "labs/03_wavefront/shared_geometry.h"
#include "labs/03_wavefront/stages.h"

#include <algorithm>
#include <chrono>

namespace raylab::lab03 {

namespace {

constexpr int warp_lanes = 32;

// Room for Whitted's pending rays: one on each level that can split.
int branches(const RenderSettings& settings) {
    return settings.integrator == Integrator::whitted ? std::max(1, settings.max_depth - 1) : 0;
}

// Every material's kind once, by number.
std::array<bool, material_kinds> kinds_in(const Scene& scene) {
    std::array<bool, material_kinds> present{};
    for (const Material& material : scene.materials)
        present[static_cast<int>(material.kind)] = true;
    return present;
}

// Device memory for each slot of a pool of n: the path, its branches, three lists, the queues, and
// what compaction needs.
std::size_t slot_bytes(const Scene& scene, const WavefrontSettings& settings, std::int64_t n) {
    std::size_t lists = 3;
    if (settings.sort == MaterialSort::queues)
        for (const bool present : kinds_in(scene)) lists += present;
    const std::size_t words = (Compaction::words(settings.scan, n) + n - 1) / n;
    return path_bytes + branch_bytes(branches(scene.render)) + 4 * (lists + words);
}

class WavefrontRenderer final : public Renderer {
  public:
    WavefrontRenderer(const Scene& scene, const MachineSettings& machine, int pool_paths);

    void add_iteration() override {
        const auto start = std::chrono::steady_clock::now();
        configure_machine(machine_);
        write_wave();
        if (settings_.regenerate)
            trace_all();
        else
            for (int first = 0; first < pixels_; first += pool_paths_)
                trace_batch(first, std::min(pool_paths_, pixels_ - first));
        check(cudaDeviceSynchronize(), "cudaDeviceSynchronize");
        ++samples_;
        seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }

    Film film() const override {
        Film film(host_scene_.camera.width, host_scene_.camera.height);
        film.pixels = film_.to_host();
        return film;
    }

    std::vector<PathRecord> records() const override { return records_.to_host(); }

    Ledger ledger() const override;

  private:
    // The lecture's five steps, for the pixels first ... first + n - 1.
    void trace_batch(int first, int n) {
        generate(first, n); // 1. A pool of rays to be tested. 2. Colours, unaccumulated yet.
        for (int bounce = 0; alive_ > 0 && bounce < most_bounces_; ++bounce) {
            intersect(&bounces_[ledger_row(bounce)]); // 3. ONE bounce of every ray,
            sort_by_material();
            shade();
            shadow();             //    and the next rays recorded in the pool.
            remove_ended(bounce); // 4. Terminated rays leave the pool.
        }                         // 5. Repeat.
        accumulate(n);
    }

    // The same with *persistent paths*: a path that ends makes room for the next pixel's at once,
    // so that the pool stays full and there is nothing to remove until the pixels run out. Paths of
    // all bounces share a launch. Aila and Laine, Understanding the Efficiency of Ray Traversal on
    // GPUs, HPG 2009, section 3.3; Novak, Havran and Dachsbacher, Path Regeneration, 2010.
    void trace_all() {
        generate(0, pool_paths_);
        set_next_pixel(pool_paths_);
        while (alive_ > 0) {
            intersect(nullptr);
            sort_by_material();
            shade();
            shadow();
            regenerate();
        }
    }

    // A thread for each of the n slots in the list; none, no launch.
    void launch(Stage stage, StageKernel* kernel, const int* slots, int n, std::size_t shared = 0) {
        if (n == 0) return;
        const int block = machine_.block_size, blocks = blocks_for(n, block);
        clock_->time(stage, blocks, std::uint64_t{1} * blocks * block,
                     [&] { kernel<<<blocks, block, shared>>>(wave_.data(), slots, n); });
    }

    void write_wave();
    void generate(int first, int n);
    void intersect(BounceCounts* counts); // counts: of this bounce, or null
    void sort_by_material();
    void shade();
    void shadow();
    void remove_ended(int bounce);
    void accumulate(int n);
    void set_next_pixel(int pixel) { next_pixel_.assign({&pixel, 1}); }
    void regenerate();
    void keep_alive();

    Results results() {
        return {film_.data(), records_.data(), tallies_.data(), shadow_rays_.data(),
                results_bounces_};
    }
    int ledger_row(int bounce) const { return std::min(bounce, results_bounces_ - 1); }
    Counters read_counters() const { return counters_.to_host().front(); }

    const Scene& host_scene_;
    MachineSettings machine_;
    WavefrontSettings settings_;
    DeviceScene scene_;
    StageKernels kernels_;
    std::size_t geometry_bytes_; // of shared memory; 0: geometry stays where it is
    int pixels_, pool_paths_, most_bounces_, results_bounces_;

    Pool pool_;
    DeviceArray<Wave> wave_;
    DeviceArray<int> live_, spare_; // slots of the paths alive, and room for the next such list
    int listed_ = 0;                // slots in live_
    int alive_ = 0;                 // of those, with a path alive
    Compaction compaction_;
    std::array<DeviceArray<int>, material_kinds> kind_queues_;
    DeviceArray<int> feelers_;
    DeviceArray<Counters> counters_;
    DeviceArray<int> next_pixel_; // the first without a path yet, of paths that regenerate
    DeviceArray<Hit> first_hits_; // a pixel each, or none

    DeviceArray<FilmPixel> film_;
    DeviceArray<PathRecord> records_;
    DeviceArray<EndTally> tallies_;
    DeviceArray<unsigned long long> shadow_rays_;
    std::unique_ptr<StageClock> clock_ = std::make_unique<StageClock>();
    std::vector<BounceCounts> bounces_; // lanes, blocks and batches alone
    int in_flight_;                     // blocks of the intersect kernel
    std::uint32_t samples_ = 0;
    double seconds_ = 0;
};

WavefrontRenderer::WavefrontRenderer(const Scene& scene, const MachineSettings& machine,
                                     int pool_paths)
    : host_scene_(scene), machine_(machine), settings_(machine.wavefront), scene_(scene),
      kernels_(
          choose_kernels(features_of(scene), scene.render.integrator, settings_.shared_geometry)),
      geometry_bytes_(settings_.shared_geometry ? geometry_bytes(scene_.view()) : 0),
      pixels_(scene.camera.width * scene.camera.height), pool_paths_(pool_paths),
      most_bounces_(scene.render.max_depth), results_bounces_(scene.render.max_depth),
      pool_(pool_paths, branches(scene.render)), wave_(1), live_(pool_paths), spare_(pool_paths),
      compaction_(settings_.scan, pool_paths, machine.block_size), feelers_(pool_paths),
      counters_(1), next_pixel_(1), first_hits_(settings_.first_bounce_cache ? pixels_ : 0),
      film_(pixels_), records_(pixels_), shadow_rays_(shards) {
    if (scene.render.integrator == Integrator::whitted) {
        most_bounces_ = 1 << scene.render.max_depth; // every node of a tree
        results_bounces_ = 64;
    }
    tallies_ = DeviceArray<EndTally>(static_cast<std::size_t>(shards) * results_bounces_);
    bounces_.resize(results_bounces_);
    if (settings_.sort == MaterialSort::queues) {
        const auto present = kinds_in(scene);
        for (int kind = 0; kind < material_kinds; ++kind)
            if (present[kind]) kind_queues_[kind] = DeviceArray<int>(pool_paths);
    }
    in_flight_ = blocks_in_flight(kernels_.intersect, machine.block_size, geometry_bytes_);
}

void WavefrontRenderer::write_wave() {
    Wave wave{scene_.view(), host_scene_.render, samples_, pool_.view(), {}, {}};
    for (int kind = 0; kind < material_kinds; ++kind)
        wave.queues.kind[kind] = kind_queues_[kind].data();
    wave.queues.feelers = feelers_.data();
    wave.queues.counters = counters_.data();
    wave.first_bounce = {first_hits_.data(), samples_ > 0};
    wave_.assign({&wave, 1});
}

void WavefrontRenderer::generate(int first, int n) {
    const int block = machine_.block_size, blocks = blocks_for(n, block);
    clock_->time(Stage::generate, blocks, std::uint64_t{1} * blocks * block, [&] {
        generate_kernel<<<blocks, block>>>(wave_.data(), first, n,
                                           settings_.regenerate ? pixels_ : n, settings_.shuffle,
                                           live_.data());
    });
    listed_ = alive_ = n;
    if (!settings_.regenerate)
        bounces_[0].lanes += std::uint64_t{1} * blocks_for(n, warp_lanes) * warp_lanes;
}

void WavefrontRenderer::intersect(BounceCounts* counts) {
    const LaunchSize size = launch_size(listed_, machine_.block_size, in_flight_);
    if (counts) {
        counts->blocks += size.blocks;
        counts->batches += size.batches;
    }
    counters_.clear();
    launch(Stage::intersect, kernels_.intersect, live_.data(), listed_, geometry_bytes_);
}

// Three bits number the kinds: three stable splits, from the lowest bit up, are a radix sort.
void WavefrontRenderer::sort_by_material() {
    if (settings_.sort != MaterialSort::on) return;
    const int block = machine_.block_size, blocks = blocks_for(listed_, block);
    clock_->time(Stage::sort, 6 * blocks, std::uint64_t{6} * blocks * block, [&] {
        for (int bit = 0; bit < 3; ++bit) {
            compaction_.split_by_bit(pool_.view().kind, bit, live_.data(), listed_, spare_.data());
            std::swap(live_, spare_);
        }
    });
}

void WavefrontRenderer::shade() {
    if (settings_.sort != MaterialSort::queues)
        return launch(Stage::shade, kernels_.shade, live_.data(), listed_);
    const Counters counters = read_counters();
    for (int kind = 0; kind < material_kinds; ++kind)
        launch(Stage::shade, kernels_.shade_kind[kind], kind_queues_[kind].data(),
               counters.kind[kind]);
}

void WavefrontRenderer::shadow() {
    launch(Stage::shadow, kernels_.shadow, feelers_.data(), read_counters().feelers,
           geometry_bytes_);
}

void WavefrontRenderer::keep_alive() {
    const int block = machine_.block_size, blocks = blocks_for(listed_, block);
    clock_->time(Stage::compact, 2 * blocks, std::uint64_t{2} * blocks * block, [&] {
        alive_ = compaction_.keep_alive(pool_.view().alive, live_.data(), listed_, spare_.data());
    });
    std::swap(live_, spare_);
    listed_ = alive_;
}

void WavefrontRenderer::remove_ended(int bounce) {
    BounceCounts& next = bounces_[ledger_row(bounce + 1)];
    if (settings_.compact_every > 0 && (bounce + 1) % settings_.compact_every == 0) {
        keep_alive();
        next.lanes += std::uint64_t{1} * blocks_for(alive_, warp_lanes) * warp_lanes;
        return;
    }
    const int block = machine_.block_size;
    const int warps = blocks_for(listed_, warp_lanes), blocks = blocks_for(warps, block);
    clock_->time(Stage::compact, blocks, std::uint64_t{1} * blocks * block, [&] {
        compaction_.count_alive(pool_.view().alive, live_.data(), listed_, counters_.data());
    });
    const Counters counters = read_counters();
    alive_ = counters.alive;
    next.lanes += std::uint64_t{1} * counters.busy_warps * warp_lanes;
}

void WavefrontRenderer::accumulate(int n) {
    const int block = machine_.block_size, blocks = blocks_for(n, block);
    clock_->time(Stage::accumulate, blocks, std::uint64_t{1} * blocks * block,
                 [&] { accumulate_kernel<<<blocks, block>>>(wave_.data(), n, results()); });
}

// Slots that find no pixel any more leave the list at once, or they would be accumulated twice.
void WavefrontRenderer::regenerate() {
    const int block = machine_.block_size, blocks = blocks_for(listed_, block);
    clock_->time(Stage::accumulate, blocks, std::uint64_t{1} * blocks * block, [&] {
        regenerate_kernel<<<blocks, block>>>(wave_.data(), live_.data(), listed_,
                                             next_pixel_.data(), pixels_, settings_.shuffle,
                                             results());
    });
    if (next_pixel_.to_host().front() <= pixels_) return;
    keep_alive();
    if (listed_ == 0) return;
    // Counted again: while compaction is a stub that removes nothing, the loop must end, too.
    compaction_.count_alive(pool_.view().alive, live_.data(), listed_, counters_.data());
    alive_ = read_counters().alive;
}

// The shards are added up; a path that ended in bounce b was alive in bounces 0 to b, so rays are
// sums over the bounces that follow.
Ledger WavefrontRenderer::ledger() const {
    Ledger ledger = begin_ledger(host_scene_, "03_wavefront", machine_name());
    ledger.samples = static_cast<int>(samples_);
    ledger.seconds = seconds_;
    ledger.pool_paths = pool_paths_;
    ledger.path_bytes = static_cast<int>(slot_bytes(host_scene_, settings_, pool_paths_));
    ledger.stages = clock_->counts();
    for (const StageCounts& stage : ledger.stages) ledger.threads_launched += stage.threads;

    const std::vector<EndTally> tallies = tallies_.to_host();
    ledger.bounces = bounces_;
    std::uint64_t rays = 0;
    for (int bounce = results_bounces_ - 1; bounce >= 0; --bounce) {
        BounceCounts& counts = ledger.bounces[bounce];
        for (int shard = 0; shard < shards; ++shard)
            for (int end = 0; end < path_ends; ++end) {
                const std::size_t row = static_cast<std::size_t>(shard) * results_bounces_ + bounce;
                counts.ended[end] += tallies[row].ended[end];
                rays += tallies[row].ended[end];
            }
        counts.rays = rays;
    }
    for (const unsigned long long count : shadow_rays_.to_host()) ledger.shadow_rays += count;
    for (const FilmPixel& pixel : film_.to_host()) ledger.rejected += pixel.rejected;
    return ledger;
}

} // namespace

std::unique_ptr<Renderer> make_renderer(const Scene& scene, const MachineSettings& machine) {
    const WavefrontSettings& settings = machine.wavefront;
    const SceneView host = view(scene);
    if (settings.shared_geometry && geometry_bytes(host) > shared_memory_limit)
        throw SettingsError(
            "the shapes of '" + scene.name + "' take " + std::to_string(geometry_bytes(host)) +
            " bytes, a block's shared memory has " + std::to_string(shared_memory_limit) +
            ": leave the geometry in global memory for this scene");

    if (settings.first_bounce_cache)
        if (const auto why_not = no_first_bounce_cache(scene))
            throw SettingsError("a first-bounce cache would be wrong here: " + *why_not);

    cudaDeviceProp device{};
    check(cudaGetDeviceProperties(&device, 0), "cudaGetDeviceProperties");
    const std::int64_t budget = settings.memory_budget > 0
                                    ? settings.memory_budget
                                    : static_cast<std::int64_t>(device.totalGlobalMem);
    const int pixels = scene.camera.width * scene.camera.height;
    const int wanted = std::min(settings.pool, pixels);
    const std::size_t cache = settings.first_bounce_cache ? sizeof(Hit) : 0;
    const MemoryNeeds needs = {scene_bytes(host),
                               pixels * (sizeof(FilmPixel) + sizeof(PathRecord) + cache),
                               slot_bytes(scene, settings, wanted)};
    return std::make_unique<WavefrontRenderer>(scene, machine,
                                               pool_that_fits(budget, needs, wanted));
}

} // namespace raylab::lab03
