#include "labs/03_wavefront/tests/one_path.h"

#include "common/device/device_scene.h"
#include "common/device/launch.h"
#include "common/scene/scene_features.h"
#include "common/wavefront/memory_budget.h"
#include "labs/03_wavefront/kernels.h"
#include "labs/03_wavefront/shade.h"
#include "labs/03_wavefront/shade_whitted.h"
#include "labs/03_wavefront/trace.h"

namespace raylab::lab03 {

namespace {

constexpr Features in_these_tests = feature::sphere | feature::plane | feature::point_light |
                                    feature::environment | feature::diffuse | feature::mirror |
                                    feature::glass;

__device__ PathState state_of(const PoolView& pool, int slot, bool sends) {
    PathState state{pool.hit[slot].found(),
                    pool.kind[slot],
                    pool.alive[slot] != 0,
                    pool.record[slot],
                    pool.radiance[slot],
                    pool.throughput[slot],
                    pool.origin[slot],
                    pool.direction[slot],
                    pool.bounce[slot],
                    pool.bsdf_pdf[slot],
                    sends,
                    pool.shadow_ray_light[slot],
                    0,
                    0,
                    {}};
    if (pool.stack == nullptr) return state;
    state.node = pool.node[slot];
    state.pending = pool.pending[slot];
    if (state.pending > 0)
        state.newest =
            pool.stack[static_cast<std::int64_t>(state.pending - 1) * pool.capacity + slot];
    return state;
}

// As the kernels do it: the dead are passed by, and where the ray left there is nothing to shade.
template <Integrator I>
__global__ void follow(const WavefrontView* wave, PathBegin begin, PathState* states) {
    constexpr Features F = in_these_tests;
    const PoolView& pool = wave->pool;
    const int slot = begin.slot;
    generate_path(*wave, slot, 4);
    pool.kind[slot] = 99;
    pool.bounce[slot] = begin.bounce;
    pool.throughput[slot] = Vec3(begin.throughput);
    for (int stage = 0; stage < path_states; ++stage) {
        bool sends = false;
        if (pool.alive[slot] && stage % 2 == 0) {
            intersect_path<F, I>(*wave, wave->scene, slot);
        } else if (pool.alive[slot] && pool.hit[slot].found()) {
            if constexpr (I == Integrator::whitted)
                shade_whitted<F>(*wave, slot);
            else
                sends = shade_path<F>(*wave, slot);
        }
        states[stage] = state_of(pool, slot, sends);
    }
}

} // namespace

std::vector<PathState> follow_path(const Scene& scene, const PathBegin& begin) {
    const DeviceScene device(scene);
    SlotMemory memory(4);
    const PoolView pool(branches_of(scene.render), &memory);
    const WavefrontView wave{device.view(), scene.render, begin.sample, pool, {}, {}};
    const DeviceArray<WavefrontView> view(std::span(&wave, 1));
    DeviceArray<PathState> states(path_states);
    if (scene.render.integrator == Integrator::whitted)
        follow<Integrator::whitted><<<1, 1>>>(view.data(), begin, states.data());
    else
        follow<Integrator::path><<<1, 1>>>(view.data(), begin, states.data());
    check(cudaDeviceSynchronize(), "follow");
    return states.to_host();
}

Started start_paths(const Scene& scene, int first, int n, std::uint32_t shuffle) {
    const int room = 2 * n + 64;
    const DeviceScene device(scene);
    SlotMemory memory(room);
    const PoolView pool(branches_of(scene.render), &memory);
    const std::vector<std::uint32_t> no_pixels(room, unwritten_pixel);
    check(cudaMemcpy(pool.pixel, no_pixels.data(), room * sizeof no_pixels[0],
                     cudaMemcpyHostToDevice),
          "the pool's pixels");
    const WavefrontView wave{device.view(), scene.render, 0, pool, {}, {}};
    const DeviceArray<WavefrontView> view(std::span(&wave, 1));
    DeviceArray<int> live(std::vector<int>(room, -1));
    generate_kernel<<<blocks_for(n, 32), 32>>>(view.data(), first, n, n, shuffle, live.data());
    check(cudaDeviceSynchronize(), "generate_kernel");
    Started started{live.to_host(), std::vector<std::uint32_t>(room)};
    check(cudaMemcpy(started.pixel.data(), pool.pixel, room * sizeof started.pixel[0],
                     cudaMemcpyDeviceToHost),
          "the pool's pixels");
    return started;
}

} // namespace raylab::lab03
