// Which thread does what: in every stage, thread i works for the i-th slot of a list.
#include "labs/04_accel/kernels.h"

#include "common/scene/variants.h"
#include "common/wavefront/accumulate.h"
#include "common/wavefront/generate.h"
#include "common/wavefront/grid.h"
#include "common/wavefront/record_end.h"
#include "common/wavefront/shade.h"
#include "labs/04_accel/shade_whitted.h"
#include "labs/04_accel/trace.h"

namespace raylab::lab04 {

namespace {

__device__ void queue_shadow_ray(const WavefrontView& wave, int slot) {
    push(wave.shadow_rays, *wave.shadow_rays_sent, slot);
}

// A path that has left, or a branch of a tree that comes to the next only now, has no hit to shade.
__device__ bool has_surface(const WavefrontView& wave, int slot) {
    return wave.pool.alive[slot] && wave.pool.hit[slot].found();
}

template <Features F, Integrator I>
__global__ void intersect_kernel(const WavefrontView* wave, const int* live, int n) {
    const std::int64_t i = global_index();
    if (i < n) intersect_path<F, I>(*wave, live[i]);
}

template <Features F, Integrator I>
__global__ void shadow_kernel(const WavefrontView* wave, const int* shadow_rays, int n) {
    const std::int64_t i = global_index();
    if (i < n) shadow_path<F, I>(*wave, shadow_rays[i]);
}

template <Features F, Integrator I>
__global__ void shade_kernel(const WavefrontView* wave, const int* live, int n) {
    const std::int64_t i = global_index();
    if (i >= n || !has_surface(*wave, live[i])) return;
    if constexpr (I == Integrator::whitted)
        shade_whitted<F>(*wave, live[i]);
    else if (shade_path<F>(*wave, live[i]))
        queue_shadow_ray(*wave, live[i]);
}

template <Features F>
__global__ void shadow_rays_kernel(const WavefrontView* wave, const int* live, int n, int light) {
    const std::int64_t i = global_index();
    if (i < n && has_surface(*wave, live[i]) && send_whitted_shadow_ray<F>(*wave, live[i], light))
        queue_shadow_ray(*wave, live[i]);
}

template <Features F, Integrator I> StageKernels kernels_of() {
    StageKernels kernels{intersect_kernel<F, I>, shade_kernel<F, I>, shadow_kernel<F, I>, nullptr};
    if constexpr (I == Integrator::whitted) kernels.shadow_rays = shadow_rays_kernel<F>;
    return kernels;
}

} // namespace

StageKernels choose_kernels(Features features, Integrator integrator) {
    return with_variant(features, [&]<Features F>() {
        return integrator == Integrator::path ? kernels_of<F, Integrator::path>()
                                              : kernels_of<F, Integrator::whitted>();
    });
}

__global__ void generate_kernel(const WavefrontView* wave, int first, int n, int* live) {
    const std::int64_t i = global_index();
    if (i >= n) return;
    const int slot = static_cast<int>(i);
    generate_path(*wave, slot, first + slot);
    live[i] = slot;
}

__global__ void add_counts_kernel(const WalkCounts* counts, int n, WalkTally* tally) {
    const std::int64_t first = global_index() * counts_per_thread;
    unsigned long long nodes = 0, packs = 0;
    for (std::int64_t i = first; i < first + counts_per_thread && i < n; ++i) {
        nodes += counts[i].nodes;
        packs += counts[i].packs;
    }
    if (first >= n) return;
    atomicAdd(&tally->nodes, nodes);
    atomicAdd(&tally->packs, packs);
}

__global__ void accumulate_kernel(const WavefrontView* wave, int n, Results results) {
    const std::int64_t i = global_index();
    if (i >= n) return;
    accumulate_path(wave->pool, static_cast<int>(i), results);
    record_end(wave->pool, static_cast<int>(i), results);
}

} // namespace raylab::lab04
