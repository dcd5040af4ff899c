// Stage 2: the closest hit of every ray in the pool; and stage 5, its shadow rays.
//
// These two are the only stages that read the scene's geometry, and the only ones without shading.
#pragma once

#include "common/trace/intersect.h"
#include "common/transport/emission.h"
#include "labs/03_wavefront/branches.h"

namespace raylab::lab03 {

HD Ray ray_of(const PoolView& pool, int slot) { return {pool.origin[slot], pool.direction[slot]}; }

// The kind of material at the hit.
template <Features F> HD MaterialKind kind_at(const SceneView& scene, const Hit& hit) {
    int material = 0;
    if constexpr (F & feature::sphere)
        if (hit.shape == Shape::sphere) material = scene.spheres[hit.index].tags.material;
    if constexpr (F & feature::quad)
        if (hit.shape == Shape::quad) material = scene.quads[hit.index].tags.material;
    if constexpr (F & feature::plane)
        if (hit.shape == Shape::plane) material = scene.planes[hit.index].tags.material;
    if constexpr (F & feature::triangle)
        if (hit.shape == Shape::triangle) material = scene.triangles[hit.index].tags.material;
    return scene.materials[material].kind;
}

// Finds what the slot's ray meets. A ray that leaves takes the sky's light along and ends its path,
// or its branch of the tree. scene: wave.scene, perhaps with its shapes in faster memory.
template <Features F, Integrator I>
HD void intersect_path(const Wave& wave, const SceneView& scene, int slot) {
    // Steps:
    // 1. Find what the slot's ray meets, with cached_hit(); its search is intersect<F>(scene, ray).
    // 2. Record the hit, and write it into the pool.
    // 3. A hit: write the kind of its material, and return.
    // 4. A miss: the kind is no_kind; the throughput times the sky's light joins the radiance.
    // 5. A path ends here as escaped. Whitted's tree goes on with its next branch.
    //[ task 3.1
    const PoolView& pool = wave.pool;
    const Ray ray = ray_of(pool, slot);
    const Hit hit = cached_hit(wave.first_bounce, pool.bounce[slot], pool.pixel[slot],
                               [&] { return intersect<F>(scene, ray); });
    record_hit(pool.record[slot], hit.id);
    pool.hit[slot] = hit;
    if (hit.found()) {
        pool.kind[slot] = static_cast<std::uint8_t>(kind_at<F>(scene, hit));
        return;
    }
    pool.kind[slot] = no_kind;
    constexpr bool whitted = I == Integrator::whitted;
    const DirectLight strategy = whitted ? DirectLight::light : wave.settings.direct_light;
    pool.radiance[slot] +=
        pool.throughput[slot] * escaped_light<F>(wave.scene, strategy, ray, pool.bsdf_pdf[slot]);
    if constexpr (whitted)
        next_branch(pool, slot);
    else
        end_path(pool, slot, PathEnd::escaped);
    //| not_implemented("3.1", "intersect_path()");
    //| wave.pool.kind[slot] = no_kind;
    //| end_path(wave.pool, slot, PathEnd::absorbed);
    //]
}

// The shadow ray's light joins the path's if nothing is in its way.
template <Features F> HD void shadow_path(const Wave& wave, const SceneView& scene, int slot) {
    // Steps:
    // 1. Put the shadow ray together from the pool: origin, direction, t_max.
    // 2. If nothing is in its way, its light joins the radiance.
    //[ task 3.1
    const PoolView& pool = wave.pool;
    const Ray shadow_ray = {pool.shadow_ray_origin[slot], pool.shadow_ray_direction[slot],
                            pool.shadow_ray_t_max[slot]};
    if (!occluded<F>(scene, shadow_ray)) pool.radiance[slot] += pool.shadow_ray_light[slot];
    //| not_implemented("3.1", "shadow_path()");
    //]
}

} // namespace raylab::lab03
