// Shadow rays: what the light sources send to a surface directly.
//
//     L = f(wo, wi) |cos(wi)| Le V / pdf,   V: does the shadow ray reach the light?
#pragma once

#include "common/math/index.h"
#include "common/sampling/mis.h"
#include "common/trace/offset.h"
#include "common/transport/emission.h"
#include "labs/01_recursive/intersect.h"
#include "labs/01_recursive/scatter.h"
#include "labs/01_recursive/tracer.h"

namespace raylab::lab01 {

// Light from one given light. p_choice: the probability that it was chosen; u: where on it.
inline Vec3 light_from(const Path& path, DirectLight strategy, int light, float p_choice,
                       const SurfacePoint& surface, Vec3 reflectance, Vec3 wo, Vec2 u) {
    //[ task 1.3
    const SceneView& scene = path.scene;
    const LightSample sample = sample_light<feature::all>(scene, light, surface.p, u);
    if (!sample.valid) return Vec3(0);
    if (strategy == DirectLight::bsdf && !sample.delta) return Vec3(0);

    const BsdfValue bsdf =
        evaluate(surface, scene.materials[surface.material], reflectance, wo, sample.wi);
    if (is_black(bsdf.f_cos)) return Vec3(0);

    // The environment is infinitely far: its shadow ray has no end.
    const Ray shadow_ray = sample.distance == infinity
                               ? spawn_ray(surface, sample.wi)
                               : spawn_ray_to(surface, sample.p, sample.error, sample.n);
    record_shadow_ray(path.record);
    if (any_hit(scene, shadow_ray)) return Vec3(0);

    // A BSDF sample might have found the same light, so the power heuristic weights the two. No
    // weight is needed if only the light sample can find it (a point light), or only it may.
    const float pdf = p_choice * sample.pdf;
    const bool alone = sample.delta || strategy == DirectLight::light;
    const float weight = alone ? 1.0f : power_heuristic(pdf, bsdf.pdf);
    return bsdf.f_cos * sample.radiance * (weight / pdf);
    //| not_implemented("1.3", "light_from()");
    //| return Vec3(0);
    //]
}

// Light from one light chosen at random, all with the same probability.
inline Vec3 direct_light(const Path& path, const SurfacePoint& surface, Vec3 reflectance, Vec3 wo,
                         std::uint32_t bounce) {
    const int lights = path.scene.lights.size;
    if (lights == 0 || is_specular<feature::all>(path.scene.materials[surface.material]))
        return Vec3(0);
    int light = 0;
    if (lights > 1) {
        const float u = path.sampler.get_1d(bounce_dimension(bounce, dimension::light_choice));
        light = index_of(u * lights, lights);
    }
    const Vec2 u = path.sampler.get_2d(bounce_dimension(bounce, dimension::light_point));
    return light_from(path, path.settings.direct_light, light, 1.0f / lights, surface, reflectance,
                      wo, u);
}

} // namespace raylab::lab01
