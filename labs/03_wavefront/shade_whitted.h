// Whitted's shading in a wavefront: shadow rays to every light, and both ways on from glass.
//
// A surface sends as many shadow rays as there are lights, all summed before they are weighted.
// They are traced here, where the surface is at hand, and not in a stage of their own: the pool has
// room for one shadow ray a path. Whitted 1980.
#pragma once

#include "common/trace/texture.h"
#include "common/transport/direct_light.h"
#include "common/transport/specular_split.h"
#include "common/wavefront/branches.h"
#include "common/wavefront/generate.h"
#include "labs/03_wavefront/wavefront_view.h"

namespace raylab::lab03 {

template <Features F>
HD Vec3 light_from_all(const WavefrontView& wave, int slot, const SurfacePoint& surface,
                       Vec3 reflectance, Vec3 wo) {
    const SceneView& scene = wave.scene;
    const Sampler sampler = sampler_of(wave, slot);
    Vec3 sum(0);
    for (int light = 0; light < scene.lights.size; ++light) {
        const Vec2 u = sampler.get_2d(shadow_ray_dimension(wave.pool.node[slot], light));
        sum += light_from<F>(scene, DirectLight::light, light, 1, surface, reflectance, wo, u,
                             wave.pool.record[slot]);
    }
    return sum;
}

template <Features F> HD void shade_whitted(const WavefrontView& wave, int slot) {
    // Steps:
    // 1. Read ray, throughput and depth; find surface, material, reflectance and wo.
    // 2. The throughput times the emission joins the radiance. The last surface ends the branch.
    // 3. Diffuse or glossy: the throughput times the light of all lights, and the branch ends.
    // 4. Specular: split. The refracted ray waits on the stack, as node 2 n + 1.
    // 5. The reflected ray becomes the slot's, as node 2 n: ray, throughput, depth, node.
    //[ task 3.1
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
        pool.radiance[slot] += throughput * light_from_all<F>(wave, slot, surface, reflectance, wo);
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
    //| not_implemented("3.1", "shade_whitted()");
    //| end_path(wave.pool, slot, PathEnd::absorbed);
    //]
}

} // namespace raylab::lab03
