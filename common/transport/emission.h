// The light that a ray meets at its end, from a surface that glows or from the sky. It is weighted,
// because light sampling may have counted the same light already. PBR4e 13.4; Veach 1997,
// chapter 9.
#pragma once

#include "common/light/sample_light.h"
#include "common/sampling/mis.h"
#include "common/scene/settings.h"
#include "common/trace/surface.h"

namespace raylab {

// Stands for the density of a direction that no light sample could have found: a direction from the
// camera or off a mirror.
constexpr float delta_pdf = infinity;

// Weight of emission that a ray met, whose direction had density bsdf_pdf, where light sampling
// would have chosen that direction with density light_pdf. The heuristic gives 1 to delta_pdf.
HD float emission_weight(DirectLight strategy, float bsdf_pdf, float light_pdf) {
    if (strategy == DirectLight::bsdf || bsdf_pdf == delta_pdf) return 1;
    if (strategy == DirectLight::light) return 0;
    return power_heuristic(bsdf_pdf, light_pdf);
}

// Le of the surface that `ray` hit, weighted. Black for surfaces that do not emit.
template <Features F>
HD Vec3 emitted_light(const SceneView& scene, DirectLight strategy, const Ray& ray, float bsdf_pdf,
                      const SurfacePoint& surface) {
    if (surface.light < 0) return Vec3(0);
    const Vec3 emission = scene.materials[surface.material].emission;
    if (bsdf_pdf == delta_pdf) return emission;
    const float pdf = light_pdf<F>(scene, surface.light, ray.o, ray.d, surface.p, surface.ng);
    return emission * emission_weight(strategy, bsdf_pdf, pdf / scene.lights.size);
}

// Radiance of the environment along a ray that left the scene, weighted.
template <Features F>
HD Vec3 escaped_light(const SceneView& scene, DirectLight strategy, const Ray& ray,
                      float bsdf_pdf) {
    if constexpr ((F & (feature::environment | feature::environment_map)) == 0) return Vec3(0);
    if (scene.environment.light < 0) return Vec3(0);
    const Vec3 emission = environment_radiance<F>(scene, ray.d);
    if (bsdf_pdf == delta_pdf) return emission;
    const float pdf = light_pdf<F>(scene, scene.environment.light, ray.o, ray.d, Vec3(0), Vec3(0));
    return emission * emission_weight(strategy, bsdf_pdf, pdf / scene.lights.size);
}

} // namespace raylab
