// The kernels that walk: one thread a ray, from the pool and back to it.
//
// They are templates over the walk and nothing else. What materials, lights and other shapes a
// scene has is the business of the kernels before and after them, so w walks and f variants of a
// scene's features are w + f kernels and not w * f, and a walk has the registers for itself.
//
// Walk is a type with a function
//     template <class Query> HD static void walk(const StructureView& structure, Query& query);
#pragma once

#include "common/wavefront/grid.h"
#include "labs/04_accel/wavefront_view.h"

namespace raylab::lab04 {

// After the first walk that has no end the rest of the iteration counts for nothing.
__device__ inline bool given_up(const WavefrontView& wave) {
    const int* found = &wave.walked.endless->found; // another thread may be about to write it
#if defined(__CUDACC__)
    return *static_cast<const volatile int*>(found) != 0;
#else
    return __atomic_load_n(found, __ATOMIC_ACQUIRE) != 0;
#endif
}

// i: the ray's place in the list.
__device__ inline void report(const WavefrontView& wave, std::int64_t i, int slot,
                              const Query& query) {
    wave.walked.counts[i] = query.counts();
    if (!query.endless()) return;
    EndlessRay& endless = *wave.walked.endless;
    if (atomicExch(&endless.found, 1) != 0) return;
    endless.pixel = wave.pool.pixel[slot];
    endless.ray = query.ray();
}

// The closest triangle of each ray in the list, or none.
template <class Walk>
__global__ void walk_closest_kernel(const WavefrontView* wave, const int* live, int n) {
    const std::int64_t i = global_index();
    if (i >= n) return;
    const int slot = live[i];
    ClosestHit query(wave->structure.leaves, ray_of(wave->pool, slot));
    if (!given_up(*wave)) Walk::walk(wave->structure, query);
    wave->pool.hit[slot] = query.hit();
    report(*wave, i, slot, query);
}

// Whether a triangle is in the way of each shadow ray.
template <class Walk>
__global__ void walk_any_kernel(const WavefrontView* wave, const int* shadow_rays, int n) {
    const std::int64_t i = global_index();
    if (i >= n) return;
    const int slot = shadow_rays[i];
    AnyHit query(wave->structure.leaves, shadow_ray_of(wave->pool, slot));
    if (!given_up(*wave)) Walk::walk(wave->structure, query);
    wave->pool.blocked[slot] = query.found();
    report(*wave, i, slot, query);
}

} // namespace raylab::lab04
