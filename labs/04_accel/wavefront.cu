// A launch for every stage; see wavefront.h.
#include "labs/04_accel/wavefront.h"

#include "common/scene/scene_features.h"
#include "common/wavefront/bounces.h"
#include "labs/04_accel/memory_budget.h"
#include "labs/04_accel/shapes/kernels.h"

namespace raylab::lab04 {

Wavefront::Wavefront(const Scene& scene, const MachineSettings& machine, Accel accel,
                     int pool_paths)
    : machine_(machine), scene_(scene), render_(scene.render), accel_(std::move(accel)),
      kernels_(choose_kernels(features_of(scene), scene.render.integrator)),
      most_bounces_(raylab::most_bounces(scene.render)), memory_(pool_paths),
      pool_(branches_of(scene.render), &memory_), view_(1), live_(pool_paths), spare_(pool_paths),
      compaction_(pool_paths, machine.block_size), shadow_rays_(pool_paths), shadow_rays_sent_(1),
      walk_counts_(accel_.has_triangles() || accel_.has_shape_tree() ? pool_paths : 0), endless_(1),
      results_(scene.camera.width * scene.camera.height, counted_bounces(scene.render),
               machine.records),
      walks_(counted_bounces(scene.render)) {}

void Wavefront::restart(const Camera& camera, std::uint32_t seed) {
    scene_.set_camera(camera);
    render_.seed = seed;
    results_.clear();
    walks_.clear();
    clock_ = std::make_unique<StageClock>(stage_names);
}

void Wavefront::begin_sample(std::uint32_t sample) {
    SceneView scene = scene_.view();
    const ShapeTreeView shapes = accel_.shapes(scene);
    if (accel_.has_shape_tree()) scene.sphere_groups = {}, scene.quad_groups = {};
    const WavefrontView wave{scene,
                             render_,
                             sample,
                             pool_,
                             accel_.view(scene.triangles),
                             shapes,
                             {walk_counts_.data(), endless_.data()},
                             shadow_rays_.data(),
                             shadow_rays_sent_.data()};
    view_.assign({&wave, 1});
    endless_.clear();
}

// A thread for each of the n slots in the list; none, no launch.
void Wavefront::launch(Stage stage, StageKernel* kernel, const int* slots, int n) {
    if (n == 0) return;
    const int block = machine_.block_size, blocks = blocks_for(n, block);
    timed(stage, blocks, [&] { kernel<<<blocks, block>>>(view_.data(), slots, n); });
}

// The same for a walk, and what it visited is added up.
void Wavefront::launch_walk(Stage stage, StageKernel* kernel, const int* slots, int n,
                            WalkTally* tally) {
    if (n == 0) return;
    launch(stage, kernel, slots, n);
    const int block = machine_.block_size,
              blocks = blocks_for(parts_for(n, counts_per_thread), block);
    timed(stage, blocks,
          [&] { add_counts_kernel<<<blocks, block>>>(walk_counts_.data(), n, tally); });
}

void Wavefront::generate(int first, int n) {
    const int block = machine_.block_size, blocks = blocks_for(n, block);
    timed(Stage::generate, blocks,
          [&] { generate_kernel<<<blocks, block>>>(view_.data(), first, n, live_.data()); });
    alive_ = n;
    results_.of_bounce(0).lanes += lanes_for(n);
}

void Wavefront::walk(int bounce) {
    walks_.rays_of_bounce(bounce) += alive_;
    if (accel_.has_triangles())
        launch_walk(Stage::walk, accel_.kernels().closest, live_.data(), alive_,
                    walks_.of_bounce(bounce));
    if (accel_.has_shape_tree())
        launch_walk(Stage::walk, shape_kernels().closest, live_.data(), alive_,
                    walks_.past_shapes());
}

void Wavefront::intersect() { launch(Stage::intersect, kernels_.intersect, live_.data(), alive_); }

// A path's surface sends a shadow ray to one light, while it is shaded. Whitted's sends one to
// each, and they must be back before.
void Wavefront::shade() {
    shadow_rays_sent_.clear();
    const int block = machine_.block_size, blocks = blocks_for(alive_, block);
    if (kernels_.shadow_rays != nullptr)
        for (int light = 0; light < scene_.view().lights.size; ++light) {
            timed(Stage::shade, blocks, [&] {
                kernels_.shadow_rays<<<blocks, block>>>(view_.data(), live_.data(), alive_, light);
            });
            trace_shadow_rays();
            shadow_rays_sent_.clear();
        }
    launch(Stage::shade, kernels_.shade, live_.data(), alive_);
}

void Wavefront::trace_shadow_rays() {
    const int sent = shadow_rays_sent_.to_host().front();
    walks_.shadow_rays() += sent;
    if (accel_.has_triangles())
        launch_walk(Stage::shadow_walk, accel_.kernels().any, shadow_rays_.data(), sent,
                    walks_.of_shadow_rays());
    if (accel_.has_shape_tree())
        launch_walk(Stage::shadow_walk, shape_kernels().any, shadow_rays_.data(), sent,
                    walks_.shadow_rays_past_shapes());
    launch(Stage::shadow, kernels_.shadow, shadow_rays_.data(), sent);
}

void Wavefront::remove_ended(int bounce) {
    timed(Stage::compact, 2 * blocks_for(alive_, machine_.block_size), [&] {
        alive_ = compaction_.keep_alive(pool_.alive, live_.data(), alive_, spare_.data());
    });
    std::swap(live_, spare_);
    results_.of_bounce(bounce + 1).lanes += lanes_for(alive_);
}

void Wavefront::accumulate(int n) {
    const int block = machine_.block_size, blocks = blocks_for(n, block);
    timed(Stage::accumulate, blocks,
          [&] { accumulate_kernel<<<blocks, block>>>(view_.data(), n, results_.view()); });
}

} // namespace raylab::lab04
