// Which thread does what: in every stage, thread i works for the i-th slot of a list.
//
// The list has one entry for each ray, so a launch needs fewer threads from bounce to bounce: "as a
// result, each iteration requires fewer blocks".
#include "labs/03_wavefront/kernels.h"

#include "common/scene/variants.h"
#include "common/task/not_implemented.h"
#include "common/wavefront/generate.h"
#include "common/wavefront/grid.h"
#include "common/wavefront/record_end.h"
#include "labs/03_wavefront/accumulate.h"
#include "labs/03_wavefront/shade.h"
#include "labs/03_wavefront/shade_whitted.h"
#include "labs/03_wavefront/shared_geometry.h"
#include "labs/03_wavefront/shuffle.h"
#include "labs/03_wavefront/trace.h"

namespace raylab::lab03 {

namespace {

// Intersects one path and queues what it hit.
template <Features F, Integrator I>
__device__ void intersect_slot(const WavefrontView& wave, const SceneView& scene, int slot) {
    const PoolView& pool = wave.pool;
    if (!pool.alive[slot]) return;
    intersect_path<F, I>(wave, scene, slot);
    const int kind = pool.kind[slot];
    if (kind != no_kind && wave.queues.kind[kind])
        push(wave.queues.kind[kind], wave.queues.counters->kind[kind], slot);
}

template <Features F, Integrator I>
__global__ void intersect_kernel(const WavefrontView* wave, const int* live, int n) {
    const std::int64_t i = global_index();
    if (i < n) intersect_slot<F, I>(*wave, wave->scene, live[i]);
}

// Threads without a slot copy geometry too, and may not leave before the barrier.
template <Features F, Integrator I>
__global__ void intersect_shared_kernel(const WavefrontView* wave, const int* live, int n) {
    extern __shared__ float4 memory[];
    const SceneView scene = geometry_in_shared_memory<F>(wave->scene, memory);
    __syncthreads();
    const std::int64_t i = global_index();
    if (i < n) intersect_slot<F, I>(*wave, scene, live[i]);
}

template <Features F>
__global__ void shadow_kernel(const WavefrontView* wave, const int* shadow_rays, int n) {
    const std::int64_t i = global_index();
    if (i < n) shadow_path<F>(*wave, wave->scene, shadow_rays[i]);
}

template <Features F>
__global__ void shadow_shared_kernel(const WavefrontView* wave, const int* shadow_rays, int n) {
    extern __shared__ float4 memory[];
    const SceneView scene = geometry_in_shared_memory<F>(wave->scene, memory);
    __syncthreads();
    const std::int64_t i = global_index();
    if (i < n) shadow_path<F>(*wave, scene, shadow_rays[i]);
}

template <Features F, Integrator I>
__global__ void shade_kernel(const WavefrontView* wave, const int* slots, int n) {
    const std::int64_t i = global_index();
    if (i >= n) return;
    const int slot = slots[i];
    if (!wave->pool.alive[slot] || wave->pool.kind[slot] == no_kind) return;
    if constexpr (I == Integrator::whitted)
        shade_whitted<F>(*wave, slot);
    else if (shade_path<F>(*wave, slot))
        push(wave->queues.shadow_rays, wave->queues.counters->shadow_rays, slot);
}

constexpr Features any_material = feature::diffuse | feature::mirror | feature::glass |
                                  feature::phong | feature::conductor | feature::rough_dielectric;

// The shading kernel for one kind of material, F without the others; null if F lacks it.
template <Features F, Integrator I, Features Kind> StageKernel* shade_alone() {
    if constexpr ((F & Kind) == 0)
        return nullptr;
    else
        return shade_kernel<F&(~any_material | Kind), I>;
}

template <Features F, Integrator I> StageKernels kernels_of(bool shared_geometry) {
    return {
        .intersect = shared_geometry ? intersect_shared_kernel<F, I> : intersect_kernel<F, I>,
        .shadow = shared_geometry ? shadow_shared_kernel<F> : shadow_kernel<F>,
        .shade = shade_kernel<F, I>,
        // In the order of MaterialKind.
        .shade_kind = {shade_alone<F, I, feature::diffuse>(), shade_alone<F, I, feature::mirror>(),
                       shade_alone<F, I, feature::glass>(), shade_alone<F, I, feature::phong>(),
                       shade_alone<F, I, feature::conductor>(),
                       shade_alone<F, I, feature::rough_dielectric>()},
    };
}

} // namespace

StageKernels choose_kernels(Features features, Integrator integrator, bool shared_geometry) {
    return with_variant(features, [&]<Features F>() {
        return integrator == Integrator::path ? kernels_of<F, Integrator::path>(shared_geometry)
                                              : kernels_of<F, Integrator::whitted>(shared_geometry);
    });
}

__global__ void generate_kernel(const WavefrontView* wave, int first, int n, int dealt,
                                std::uint32_t shuffle, int* live) {
    // Steps:
    // 1. Find the number i of this thread in the grid. A thread from n on has nothing to do.
    // 2. Slot i gets the path of pixel first + shuffled(i, dealt, shuffle).
    // 3. The slot joins the list, at place i.
    //[ task 3.1
    const std::int64_t i = global_index();
    if (i >= n) return;
    const int slot = static_cast<int>(i);
    generate_path(*wave, slot, first + shuffled(slot, dealt, shuffle));
    live[i] = slot;
    //| not_implemented("3.1", "generate_kernel()");
    //]
}

__global__ void regenerate_kernel(const WavefrontView* wave, const int* live, int n, int* next,
                                  int pixels, std::uint32_t shuffle, Results results) {
    const std::int64_t i = global_index();
    if (i >= n || wave->pool.alive[live[i]]) return;
    const int slot = live[i];
    accumulate_path(wave->pool, slot, results);
    record_end(wave->pool, slot, results);
    const int pixel = atomicAdd(next, 1);
    if (pixel < pixels) generate_path(*wave, slot, shuffled(pixel, pixels, shuffle));
}

__global__ void accumulate_kernel(const WavefrontView* wave, int n, Results results) {
    const std::int64_t i = global_index();
    if (i >= n) return;
    accumulate_path(wave->pool, static_cast<int>(i), results);
    record_end(wave->pool, static_cast<int>(i), results);
}

} // namespace raylab::lab03
