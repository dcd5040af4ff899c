// The shapes in no tree, and what follows from a hit.
//
// Walks have left the closest hit so far in the pool, and whether something blocks the shadow ray;
// here the other shapes are tested against that. All of them: planes are infinite, and of spheres
// and quads there are few, or they have a tree too.
#pragma once

#include "common/trace/intersect.h"
#include "common/transport/emission.h"
#include "common/wavefront/branches.h"
#include "labs/04_accel/wavefront_view.h"

namespace raylab::lab04 {

constexpr Features without_triangles(Features features) { return features & ~feature::triangle; }

// Settles what the slot's ray meets. A ray that leaves takes the sky's light along and ends its
// path, or its branch of the tree.
template <Features F, Integrator I> HD void intersect_path(const WavefrontView& wave, int slot) {
    const PoolView& pool = wave.pool;
    const Ray ray = ray_of(pool, slot);
    const bool walked = wave.scene.triangles.size > 0 || wave.shapes.boxes.nodes.size > 0;
    const Hit hit =
        intersect<without_triangles(F)>(wave.scene, ray, walked ? pool.hit[slot] : Hit{});
    record_hit(pool.record[slot], hit.id);
    pool.hit[slot] = hit;
    constexpr bool whitted = I == Integrator::whitted;
    if constexpr (whitted) pool.direct[slot] = Vec3(0);
    if (hit.found()) return;
    const DirectLight strategy = whitted ? DirectLight::light : wave.settings.direct_light;
    pool.radiance[slot] +=
        pool.throughput[slot] * escaped_light<F>(wave.scene, strategy, ray, pool.bsdf_pdf[slot]);
    if constexpr (whitted)
        next_branch(pool, slot);
    else
        end_path(pool, slot, PathEnd::escaped);
}

// The shadow ray's light joins the path's, or Whitted's sum over the lights, if nothing is in its
// way.
template <Features F, Integrator I> HD void shadow_path(const WavefrontView& wave, int slot) {
    const PoolView& pool = wave.pool;
    if (pool.blocked[slot]) return;
    if (occluded<without_triangles(F)>(wave.scene, shadow_ray_of(pool, slot))) return;
    Vec3& gains = I == Integrator::whitted ? pool.direct[slot] : pool.radiance[slot];
    gains += pool.shadow_ray_light[slot];
}

} // namespace raylab::lab04
