#include "labs/04_accel/shapes/kernels.h"

#include "labs/04_accel/bvh/walk_trail.h"
#include "labs/04_accel/shapes/query.h"
#include "labs/04_accel/walk_kernels.h"

namespace raylab::lab04 {

namespace {

// Without triangles nothing has walked before, and the pool holds what an earlier ray left.
__device__ bool walked_before(const WavefrontView& wave) { return wave.scene.triangles.size > 0; }

__global__ void closest_shape_kernel(const WavefrontView* wave, const int* live, int n) {
    const std::int64_t i = global_index();
    if (i >= n) return;
    const int slot = live[i];
    ClosestShape query(wave->scene, wave->shapes, ray_of(wave->pool, slot),
                       walked_before(*wave) ? wave->pool.hit[slot] : Hit{});
    if (!given_up(*wave)) walk_bvh_trail(wave->shapes.boxes, query);
    wave->pool.hit[slot] = query.hit();
    report(*wave, i, slot, query);
}

__global__ void any_shape_kernel(const WavefrontView* wave, const int* shadow_rays, int n) {
    const std::int64_t i = global_index();
    if (i >= n) return;
    const int slot = shadow_rays[i];
    const bool blocked = walked_before(*wave) && wave->pool.blocked[slot];
    AnyShape query(wave->scene, wave->shapes, shadow_ray_of(wave->pool, slot));
    if (!blocked && !given_up(*wave)) walk_bvh_trail(wave->shapes.boxes, query);
    wave->pool.blocked[slot] = blocked || query.found();
    report(*wave, i, slot, query);
}

} // namespace

WalkKernels shape_kernels() { return {closest_shape_kernel, any_shape_kernel}; }

} // namespace raylab::lab04
