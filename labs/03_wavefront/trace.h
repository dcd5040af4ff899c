// Stage 2: the closest hit of every ray in the pool; and stage 5, its shadow rays.
//
// These two are the only stages that read the scene's geometry, and the only ones without shading.
#pragma once

#include "common/trace/intersect.h"
#include "common/trace/material_at.h"
#include "common/transport/emission.h"
#include "common/wavefront/branches.h"
#include "labs/03_wavefront/wavefront_view.h"

namespace raylab::lab03 {

// Finds what the slot's ray meets. A ray that leaves takes the sky's light along and ends its path,
// or its branch of the tree. scene: wave.scene, perhaps with its shapes in faster memory.
template <Features F, Integrator I>
HD void intersect_path(const WavefrontView& wave, const SceneView& scene, int slot) {
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
        pool.kind[slot] = static_cast<std::uint8_t>(material_at<F>(scene, hit).kind);
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
template <Features F>
HD void shadow_path(const WavefrontView& wave, const SceneView& scene, int slot) {
    // Steps:
    // 1. Ask whether anything is in the way of shadow_ray_of(pool, slot).
    // 2. If nothing is, its light joins the radiance.
    //[ task 3.1
    const PoolView& pool = wave.pool;
    if (!occluded<F>(scene, shadow_ray_of(pool, slot)))
        pool.radiance[slot] += pool.shadow_ray_light[slot];
    //| not_implemented("3.1", "shadow_path()");
    //]
}

} // namespace raylab::lab03
