// Which thread does what: in every stage, thread i works for the i-th slot of a list.
//
// The list is as long as the rays are many, so that with each bounce a launch needs fewer threads:
// "as a result, each iteration requires fewer blocks".
#include "labs/03_wavefront/kernels.h"

#include "common/scene/variants.h"
#include "common/task/not_implemented.h"
#include "labs/03_wavefront/generate.h"
#include "labs/03_wavefront/grid.h"
#include "labs/03_wavefront/shade.h"
#include "labs/03_wavefront/shade_whitted.h"
#include "labs/03_wavefront/shared_geometry.h"
#include "labs/03_wavefront/trace.h"

namespace raylab::lab03 {

namespace {

// Intersects one path and queues what it hit.
template <Features F, Integrator I>
__device__ void intersect_slot(const Wave& wave, const SceneView& scene, int slot) {
    const PoolView& pool = wave.pool;
    if (!pool.alive[slot]) return;
    intersect_path<F, I>(wave, scene, slot);
    const int kind = pool.kind[slot];
    if (kind != no_kind && wave.queues.kind[kind])
        push(wave.queues.kind[kind], wave.queues.counters->kind[kind], slot);
}

template <Features F, Integrator I>
__global__ void intersect_kernel(const Wave* wave, const int* live, int n) {
    const std::int64_t i = global_index();
    if (i < n) intersect_slot<F, I>(*wave, wave->scene, live[i]);
}

// Threads without a slot copy geometry too, and may not leave before the barrier.
template <Features F, Integrator I>
__global__ void intersect_shared_kernel(const Wave* wave, const int* live, int n) {
    extern __shared__ float4 memory[];
    const SceneView scene = geometry_in_shared_memory<F>(wave->scene, memory);
    __syncthreads();
    const std::int64_t i = global_index();
    if (i < n) intersect_slot<F, I>(*wave, scene, live[i]);
}

template <Features F>
__global__ void shadow_kernel(const Wave* wave, const int* shadow_rays, int n) {
    const std::int64_t i = global_index();
    if (i < n) shadow_path<F>(*wave, wave->scene, shadow_rays[i]);
}

template <Features F>
__global__ void shadow_shared_kernel(const Wave* wave, const int* shadow_rays, int n) {
    extern __shared__ float4 memory[];
    const SceneView scene = geometry_in_shared_memory<F>(wave->scene, memory);
    __syncthreads();
    const std::int64_t i = global_index();
    if (i < n) shadow_path<F>(*wave, scene, shadow_rays[i]);
}

template <Features F, Integrator I>
__global__ void shade_kernel(const Wave* wave, const int* slots, int n) {
    const std::int64_t i = global_index();
    if (i >= n) return;
    const int slot = slots[i];
    if (!wave->pool.alive[slot] || wave->pool.kind[slot] == no_kind) return;
    if constexpr (I == Integrator::whitted)
        shade_whitted<F>(*wave, slot);
    else if (shade_path<F>(*wave, slot))
        push(wave->queues.shadow_rays, wave->queues.counters->shadow_rays, slot);
}

__device__ void count_end(const Results& results, const PathRecord& record) {
    const int shard = static_cast<int>(blockIdx.x % shards);
    const int length = record.length < results.bounces ? record.length : results.bounces;
    if (length == 0) return; // never traced
    EndTally* tally = results.tallies + static_cast<std::int64_t>(shard) * results.bounces;
    atomicAdd(&tally[length - 1].ended[static_cast<int>(record.end)], 1ull);
    atomicAdd(&results.shadow_rays[shard], static_cast<unsigned long long>(record.shadow_rays));
}

// In the order of MaterialKind.
constexpr Features kind_features[material_kinds] = {feature::diffuse,   feature::mirror,
                                                    feature::glass,     feature::phong,
                                                    feature::conductor, feature::rough_dielectric};

constexpr Features any_material = feature::diffuse | feature::mirror | feature::glass |
                                  feature::phong | feature::conductor | feature::rough_dielectric;

// The shading kernel for a kind of material: F without the others.
template <Features F, Integrator I, int Kind> StageKernel* kernel_for_kind() {
    constexpr Features alone = F & (~any_material | kind_features[Kind]);
    if constexpr ((F & kind_features[Kind]) == 0)
        return nullptr;
    else
        return shade_kernel<alone, I>;
}

template <Features F, Integrator I> StageKernels kernels_of(bool shared_geometry) {
    StageKernels kernels{};
    kernels.intersect = shared_geometry ? intersect_shared_kernel<F, I> : intersect_kernel<F, I>;
    kernels.shadow = shared_geometry ? shadow_shared_kernel<F> : shadow_kernel<F>;
    kernels.shade = shade_kernel<F, I>;
    [&]<int... Kind>(std::integer_sequence<int, Kind...>) {
        ((kernels.shade_kind[Kind] = kernel_for_kind<F, I, Kind>()), ...);
    }
    (std::make_integer_sequence<int, material_kinds>{});
    return kernels;
}

} // namespace

StageKernels choose_kernels(Features features, Integrator integrator, bool shared_geometry) {
    return with_variant(features, [&]<Features F>() {
        return integrator == Integrator::path ? kernels_of<F, Integrator::path>(shared_geometry)
                                              : kernels_of<F, Integrator::whitted>(shared_geometry);
    });
}

__global__ void generate_kernel(const Wave* wave, int first, int n, int dealt,
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

__global__ void regenerate_kernel(const Wave* wave, const int* live, int n, int* next, int pixels,
                                  std::uint32_t shuffle, Results results) {
    const std::int64_t i = global_index();
    if (i >= n || wave->pool.alive[live[i]]) return;
    const int slot = live[i];
    accumulate_path(*wave, slot, results);
    keep_record(*wave, slot, results);
    count_end(results, wave->pool.record[slot]);
    const int pixel = atomicAdd(next, 1);
    if (pixel < pixels) generate_path(*wave, slot, shuffled(pixel, pixels, shuffle));
}

__global__ void accumulate_kernel(const Wave* wave, int n, Results results) {
    const std::int64_t i = global_index();
    if (i >= n) return;
    accumulate_path(*wave, static_cast<int>(i), results);
    keep_record(*wave, static_cast<int>(i), results);
    count_end(results, wave->pool.record[i]);
}

} // namespace raylab::lab03
