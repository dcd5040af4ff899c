// Whitted's shading in a wavefront: shadow rays to every light, and both ways on from glass.
//
// A surface sends as many shadow rays as there are lights, all summed before they are weighted. In
// lab 03 they were traced where they were shaded; now each is walked by a kernel of its own, so the
// lights take turns: a shadow ray to the first from every surface, walked and settled, then to the
// second. Then the surface is shaded with the sum. Whitted 1980.
#pragma once

#include "common/trace/material_at.h"
#include "common/trace/texture.h"
#include "common/transport/direct_light.h"
#include "common/transport/specular_split.h"
#include "common/wavefront/branches.h"
#include "common/wavefront/generate.h"
#include "labs/04_accel/wavefront_view.h"

namespace raylab::lab04 {

// Sends the shadow ray to one of the lights. Returns whether there is one to be traced.
template <Features F>
HD bool send_whitted_shadow_ray(const WavefrontView& wave, int slot, int light) {
    const SceneView& scene = wave.scene;
    const PoolView& pool = wave.pool;
    const Material& material = material_at<F>(scene, pool.hit[slot]);
    if (pool.bounce[slot] + 1 == wave.settings.max_depth || is_specular<F>(material)) return false;
    const Ray ray = ray_of(pool, slot);
    const SurfacePoint surface = surface_at<F>(scene, ray, pool.hit[slot]);
    const Vec3 reflectance = reflectance_at<F>(scene, material, surface);
    const Vec2 u = sampler_of(wave, slot).get_2d(shadow_ray_dimension(pool.node[slot], light));
    const ShadowRay shadow_ray =
        shadow_ray_to<F>(scene, DirectLight::light, light, 1, surface, reflectance, -ray.d, u);
    if (shadow_ray.sent) send_shadow_ray(pool, slot, shadow_ray.ray, shadow_ray.light);
    return shadow_ray.sent;
}

template <Features F> HD void shade_whitted(const WavefrontView& wave, int slot) {
    const SceneView& scene = wave.scene;
    const PoolView& pool = wave.pool;
    const Ray ray = ray_of(pool, slot);
    const Vec3 throughput = pool.throughput[slot];
    const int depth = pool.bounce[slot];

    const SurfacePoint surface = surface_at<F>(scene, ray, pool.hit[slot]);
    const Material& material = scene.materials[surface.material];
    const Vec3 reflectance = reflectance_at<F>(scene, material, surface);
    const Vec3 wo = -ray.d;
    pool.radiance[slot] += throughput * material.emission;
    if (depth + 1 == wave.settings.max_depth) return next_branch(pool, slot);
    if (!is_specular<F>(material)) {
        pool.radiance[slot] += throughput * pool.direct[slot];
        return next_branch(pool, slot);
    }

    // The refracted ray waits, the reflected one goes on: the order of lab 02.
    const SpecularSplit split = split_specular<F>(surface, material, reflectance, wo);
    const std::uint32_t node = pool.node[slot];
    if (split.refracts) {
        const Ray refracted = spawn_ray(surface, split.refracted);
        push_branch(pool, slot,
                    {refracted.o, refracted.d, throughput * split.refracted_weight, depth + 1,
                     2 * node + 1});
    }
    const Ray reflected = spawn_ray(surface, split.reflected);
    pool.origin[slot] = reflected.o;
    pool.direction[slot] = reflected.d;
    pool.throughput[slot] = throughput * split.reflected_weight;
    pool.bounce[slot] = depth + 1;
    pool.node[slot] = 2 * node;
}

} // namespace raylab::lab04
