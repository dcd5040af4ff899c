// One interface for all lights: sample_light() chooses a point on a given light, and light_pdf()
// gives the density of that choice.
//
// F is the set of features for which a kernel is compiled (math/features.h). The kernel has no code
// for kinds of light that are not in F.
#pragma once

#include "common/light/environment.h"
#include "common/light/polygon_light.h"
#include "common/light/sphere_light.h"
#include "common/math/features.h"
#include "common/scene/view.h"

namespace raylab {

constexpr bool has_light(Features features, Features shape) {
    return (features & feature::area_light) && (features & shape);
}

HD LightSample sample_point_light(const Light& light, Vec3 from) {
    const Vec3 d = light.position - from;
    const float distance2 = length_squared(d), distance = sqrtf(distance2);
    const Vec3 wi = d / distance;
    return {light.position, 0, -wi, wi, distance, light.intensity / distance2, 1, true,
            distance2 > 0};
}

// Chooses a point on scene.lights[light] that lights the receiver at `from`. u in [0, 1)^2.
template <Features F>
HD_HOT LightSample sample_light(const SceneView& scene, int light, Vec3 from, Vec2 u) {
    const Light& l = scene.lights[light];
    switch (l.kind) {
    case LightKind::sphere:
        if constexpr (has_light(F, feature::sphere)) {
            const Sphere& sphere = scene.spheres[l.shape];
            return sample_sphere_light(sphere, scene.materials[sphere.tags.material].emission, from,
                                       u);
        }
        break;
    case LightKind::quad:
        if constexpr (has_light(F, feature::quad)) {
            const Quad& quad = scene.quads[l.shape];
            return sample_quad_light(quad, scene.materials[quad.tags.material].emission, from, u);
        }
        break;
    case LightKind::triangle:
        if constexpr (has_light(F, feature::triangle)) {
            const Triangle& triangle = scene.triangles[l.shape];
            return sample_triangle_light(triangle, scene.materials[triangle.tags.material].emission,
                                         from, u);
        }
        break;
    case LightKind::point:
        if constexpr ((F & feature::point_light) != 0) return sample_point_light(l, from);
        break;
    case LightKind::environment:
        if constexpr ((F & (feature::environment | feature::environment_map)) != 0)
            return sample_environment<F>(scene.environment, u);
        break;
    }
    return {};
}

// The density per solid angle with which sample_light would have chosen direction wi from `from`,
// for a ray that met the light at hit_point with unit normal hit_normal (unused by the
// environment). 0 for point lights, which no ray meets.
template <Features F>
HD float light_pdf(const SceneView& scene, int light, Vec3 from, Vec3 wi, Vec3 hit_point,
                   Vec3 hit_normal) {
    const Light& l = scene.lights[light];
    switch (l.kind) {
    case LightKind::sphere:
        if constexpr (has_light(F, feature::sphere))
            return sphere_light_pdf(scene.spheres[l.shape], from, wi, hit_point, hit_normal);
        break;
    case LightKind::quad:
        if constexpr (has_light(F, feature::quad))
            return quad_light_pdf(scene.quads[l.shape], from, wi, hit_point);
        break;
    case LightKind::triangle:
        if constexpr (has_light(F, feature::triangle))
            return triangle_light_pdf(scene.triangles[l.shape], from, wi, hit_point);
        break;
    case LightKind::point:
        break;
    case LightKind::environment:
        if constexpr ((F & (feature::environment | feature::environment_map)) != 0)
            return environment_pdf<F>(scene.environment, wi);
        break;
    }
    return 0;
}

} // namespace raylab
