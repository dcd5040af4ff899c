// A launch for every stage; see wavefront.h.
#include "labs/03_wavefront/wavefront.h"

#include "common/scene/scene_features.h"
#include "common/wavefront/bounces.h"
#include "labs/03_wavefront/launch_sizing.h"
#include "labs/03_wavefront/memory_budget.h"
#include "labs/03_wavefront/shared_geometry.h"

namespace raylab::lab03 {

Wavefront::Wavefront(const Scene& scene, const MachineSettings& machine, int pool_paths)
    : machine_(machine), settings_(machine.wavefront), scene_(scene), render_(scene.render),
      kernels_(
          choose_kernels(features_of(scene), scene.render.integrator, settings_.shared_geometry)),
      geometry_bytes_(settings_.shared_geometry ? geometry_bytes(scene_.view()) : 0),
      pixels_(scene.camera.width * scene.camera.height),
      most_bounces_(raylab::most_bounces(scene.render)),
      in_flight_(blocks_in_flight(kernels_.intersect, machine.block_size, geometry_bytes_)),
      memory_(pool_paths), pool_(branches_of(scene.render), &memory_), view_(1), live_(pool_paths),
      spare_(pool_paths), compaction_(settings_.scan, pool_paths, machine.block_size),
      shadow_rays_(pool_paths), counters_(1), next_pixel_(1),
      first_hits_(settings_.first_bounce_cache ? pixels_ : 0),
      results_(pixels_, counted_bounces(scene.render), machine.records) {
    if (settings_.sort != MaterialSort::queues) return;
    const auto present = kinds_in(scene);
    for (int kind = 0; kind < material_kinds; ++kind)
        if (present[kind]) kind_queues_[kind] = DeviceArray<int>(pool_paths);
}

void Wavefront::restart(const Camera& camera, std::uint32_t seed) {
    scene_.set_camera(camera);
    render_.seed = seed;
    results_.clear();
    clock_ = std::make_unique<StageClock>(stage_names);
}

void Wavefront::begin_sample(std::uint32_t sample) {
    WavefrontView wave{scene_.view(), render_, sample, pool_, {}, {}};
    for (int kind = 0; kind < material_kinds; ++kind)
        wave.queues.kind[kind] = kind_queues_[kind].data();
    wave.queues.shadow_rays = shadow_rays_.data();
    wave.queues.counters = counters_.data();
    wave.first_bounce = {first_hits_.data(), sample > 0};
    view_.assign({&wave, 1});
}

// A thread for each of the n slots in the list; none, no launch.
void Wavefront::launch(Stage stage, StageKernel* kernel, const int* slots, int n,
                       std::size_t shared) {
    if (n == 0) return;
    const int block = machine_.block_size, blocks = blocks_for(n, block);
    timed(stage, blocks, [&] { kernel<<<blocks, block, shared>>>(view_.data(), slots, n); });
}

void Wavefront::generate(int first, int n) {
    const int block = machine_.block_size, blocks = blocks_for(n, block);
    const int dealt = settings_.regenerate ? pixels_ : n;
    timed(Stage::generate, blocks, [&] {
        generate_kernel<<<blocks, block>>>(view_.data(), first, n, dealt, settings_.shuffle,
                                           live_.data());
    });
    listed_ = alive_ = n;
    if (settings_.regenerate)
        next_pixel_.assign({&n, 1});
    else
        results_.of_bounce(0).lanes += lanes_for(n);
}

void Wavefront::intersect(int bounce) {
    const LaunchSize size = launch_size(listed_, machine_.block_size, in_flight_);
    if (bounce != mixed_bounces) {
        results_.of_bounce(bounce).blocks += size.blocks;
        results_.of_bounce(bounce).batches += size.batches;
    }
    counters_.clear();
    launch(Stage::intersect, kernels_.intersect, live_.data(), listed_, geometry_bytes_);
}

// Three bits number the kinds: three stable splits, from the lowest bit up, are a radix sort.
void Wavefront::sort_by_material() {
    if (settings_.sort != MaterialSort::on) return;
    timed(Stage::sort, 6 * blocks_for(listed_, machine_.block_size), [&] {
        for (int bit = 0; bit < 3; ++bit) {
            compaction_.split_by_bit(pool_.kind, bit, live_.data(), listed_, spare_.data());
            std::swap(live_, spare_);
        }
    });
}

void Wavefront::shade() {
    if (settings_.sort != MaterialSort::queues)
        return launch(Stage::shade, kernels_.shade, live_.data(), listed_);
    const Counters counters = read_counters();
    for (int kind = 0; kind < material_kinds; ++kind)
        launch(Stage::shade, kernels_.shade_kind[kind], kind_queues_[kind].data(),
               counters.kind[kind]);
}

void Wavefront::shadow() {
    launch(Stage::shadow, kernels_.shadow, shadow_rays_.data(), read_counters().shadow_rays,
           geometry_bytes_);
}

void Wavefront::keep_alive() {
    timed(Stage::compact, 2 * blocks_for(listed_, machine_.block_size), [&] {
        alive_ = compaction_.keep_alive(pool_.alive, live_.data(), listed_, spare_.data());
    });
    std::swap(live_, spare_);
    listed_ = alive_;
}

void Wavefront::remove_ended(int bounce) {
    BounceCounts& next = results_.of_bounce(bounce + 1);
    if (settings_.compact_every > 0 && (bounce + 1) % settings_.compact_every == 0) {
        keep_alive();
        next.lanes += lanes_for(alive_);
        return;
    }
    timed(Stage::compact, blocks_for(warps_for(listed_), machine_.block_size),
          [&] { compaction_.count_alive(pool_.alive, live_.data(), listed_, counters_.data()); });
    const Counters counters = read_counters();
    alive_ = counters.alive;
    next.lanes += std::uint64_t{1} * counters.busy_warps * warp_lanes;
}

void Wavefront::accumulate(int n) {
    const int block = machine_.block_size, blocks = blocks_for(n, block);
    timed(Stage::accumulate, blocks,
          [&] { accumulate_kernel<<<blocks, block>>>(view_.data(), n, results_.view()); });
}

// Slots that find no pixel any more leave the list at once, or they would be accumulated twice.
void Wavefront::regenerate() {
    const int block = machine_.block_size, blocks = blocks_for(listed_, block);
    timed(Stage::accumulate, blocks, [&] {
        regenerate_kernel<<<blocks, block>>>(view_.data(), live_.data(), listed_,
                                             next_pixel_.data(), pixels_, settings_.shuffle,
                                             results_.view());
    });
    if (next_pixel_.to_host().front() <= pixels_) return;
    keep_alive();
    if (listed_ == 0) return;
    // Counted again: while compaction is a stub that removes nothing, the loop must end, too.
    compaction_.count_alive(pool_.alive, live_.data(), listed_, counters_.data());
    alive_ = read_counters().alive;
}

} // namespace raylab::lab03
