// Light that arrives at a surface directly from a light source. Two estimators find it: light
// sampling, and BSDF samples that hit a source by chance. PBR4e 13.4 (A Better Path Tracer); Veach
// 1997, chapter 9.
//
//   L_direct = integral of f(wo, wi) Le(p', -wi) V(p, p') |cos| dwi
// is estimated twice: by sampling lights (density p_l) and by sampling the BSDF (density p_b). The
// power heuristic gives each estimate a weight, p^2 / (p_l^2 + p_b^2). The weights add up to 1, so
// the sum is unbiased, and each estimator counts most where its own density is the higher one.
#pragma once

#include "common/film/ledger.h"
#include "common/math/index.h"
#include "common/sampling/sampler.h"
#include "common/trace/intersect.h"
#include "common/trace/offset.h"
#include "common/transport/emission.h"
#include "common/transport/scatter.h"

namespace raylab {

// A shadow ray still to be traced, and the light it brings if nothing is in its way.
struct ShadowRay {
    Ray ray;
    Vec3 light = Vec3(0);
    bool sent = false; // false: no light can come this way, there is nothing to trace
};

// The shadow ray to one given light. It brings f(wo, wi) |cos| L / p_l, times the weight of light
// sampling against BSDF sampling. p_choice: the probability that this light was chosen.
template <Features F>
HD_HOT ShadowRay shadow_ray_to(const SceneView& scene, DirectLight strategy, int light,
                               float p_choice, const SurfacePoint& surface, Vec3 reflectance,
                               Vec3 wo, Vec2 u) {
    const LightSample sample = sample_light<F>(scene, light, surface.p, u);
    if (!sample.valid) return {};
    if (strategy == DirectLight::bsdf && !sample.delta) return {};

    const BsdfValue bsdf =
        evaluate_bsdf<F>(surface, scene.materials[surface.material], reflectance, wo, sample.wi);
    if (is_black(bsdf.f_cos)) return {};

    const Ray ray = sample.distance == infinity
                        ? spawn_ray(surface, sample.wi)
                        : spawn_ray_to(surface, sample.p, sample.error, sample.n);
    const float pdf = p_choice * sample.pdf;
    const bool alone = sample.delta || strategy == DirectLight::light;
    const float weight = alone ? 1.0f : power_heuristic(pdf, bsdf.pdf);
    return {ray, bsdf.f_cos * sample.radiance * (weight / pdf), true};
}

// The shadow ray to one light chosen at random, all with the same probability.
template <Features F>
HD_HOT ShadowRay shadow_ray_to_any(const SceneView& scene, DirectLight strategy,
                                   const SurfacePoint& surface, Vec3 reflectance, Vec3 wo,
                                   const BounceNumbers& u) {
    const int lights = scene.lights.size;
    if (lights == 0 || is_specular<F>(scene.materials[surface.material])) return {};
    const int light = index_of(u.light_choice * lights, lights);
    return shadow_ray_to<F>(scene, strategy, light, 1.0f / lights, surface, reflectance, wo,
                            u.light_point);
}

// The light of the shadow ray, or black if something is in its way.
template <Features F>
HD Vec3 trace_shadow_ray(const SceneView& scene, const ShadowRay& shadow_ray, PathRecord& record) {
    if (!shadow_ray.sent) return Vec3(0);
    record_shadow_ray(record);
    return occluded<F>(scene, shadow_ray.ray) ? Vec3(0) : shadow_ray.light;
}

// Light from one given light.
template <Features F>
HD Vec3 light_from(const SceneView& scene, DirectLight strategy, int light, float p_choice,
                   const SurfacePoint& surface, Vec3 reflectance, Vec3 wo, Vec2 u,
                   PathRecord& record) {
    const ShadowRay shadow_ray =
        shadow_ray_to<F>(scene, strategy, light, p_choice, surface, reflectance, wo, u);
    return trace_shadow_ray<F>(scene, shadow_ray, record);
}

// Light from one light chosen at random.
template <Features F>
HD_HOT Vec3 direct_light(const SceneView& scene, DirectLight strategy, const SurfacePoint& surface,
                         Vec3 reflectance, Vec3 wo, const BounceNumbers& u, PathRecord& record) {
    const ShadowRay shadow_ray = shadow_ray_to_any<F>(scene, strategy, surface, reflectance, wo, u);
    return trace_shadow_ray<F>(scene, shadow_ray, record);
}

} // namespace raylab
