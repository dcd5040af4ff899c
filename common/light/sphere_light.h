// Sphere lights: from outside, the cone of directions that the sphere fills, each alike. Shirley,
// Wang and Zimmerman, Monte Carlo Techniques for Direct Lighting Calculations, 1996; PBR4e 6.2.4.
//
// In the cone every sample meets the visible side, and irradiance from a sphere above the horizon
// has no variance but the receiver's cosine. Inside the sphere, or on it, there is no such cone:
// there points are sampled uniformly by area.
#pragma once

#include "common/geometry/shapes.h"
#include "common/light/light_sample.h"
#include "common/math/frame.h"
#include "common/sampling/warp.h"

namespace raylab {

// How far rounding can put center + radius * n, n normalized, off the sphere.
HD float sphere_point_error(const Sphere& sphere) {
    return gamma_bound(8) * (max_component(abs(sphere.center)) + sphere.radius);
}

// The cone that the sphere fills as seen from a point.
struct SphereCone {
    Vec3 axis;           // unit, to the center
    float sin2;          // sin^2 of the half angle, (r / d)^2
    float one_minus_cos; // 1 - cos of it
    bool exists;         // false: `from` is inside, or within rounding of the surface
};

HD SphereCone cone_around(const Sphere& sphere, Vec3 from) {
    const Vec3 d = sphere.center - from;
    const float distance2 = length_squared(d);
    // A point on the surface must not count as outside by its rounding error: its cone would be the
    // half space in front, and the sphere's nearest point there the point itself.
    const float margin = sphere.radius + 2 * sphere_point_error(sphere);
    if (!(distance2 > sqr(margin))) return {Vec3(0), 1, 1, false};
    const float sin2 = sqr(sphere.radius) / distance2;
    return {d / sqrtf(distance2), sin2, one_minus_cos(sin2), true};
}

HD float sphere_area_pdf(const Sphere& sphere) { return uniform_sphere_pdf / sqr(sphere.radius); }

HD LightSample sample_sphere_light(const Sphere& sphere, Vec3 radiance, Vec3 from, Vec2 u) {
    const float error = sphere_point_error(sphere);
    const SphereCone cone = cone_around(sphere, from);
    if (!cone.exists) {
        const Vec3 n = sample_uniform_sphere(u);
        const Vec3 p = sphere.center + sphere.radius * n;
        return light_sample_at(from, p, error, n, sphere_area_pdf(sphere), radiance);
    }
    const Vec3 local = sample_cone(u, cone.one_minus_cos);
    const Frame frame = Frame::around(cone.axis);
    const Vec3 wi = frame.to_world(local);

    // The near point p in that direction, by the sphere's normal n there. With s = sin(theta_max) =
    // r / d and q = sin^2(theta) / s^2, the ray goes t = d cos(theta) - r sqrt(1 - q) to p, which
    // is t sin(theta) away from the axis and r cos(alpha) before the center:
    //   t / r      = (cos(theta) - s sqrt(1 - q)) / s,
    //   cos(alpha) = sin(theta) sqrt(q) + cos(theta) sqrt(1 - q).
    const float s = sqrtf(cone.sin2);
    const float sin2_theta = local.x * local.x + local.y * local.y;
    const float q = glm::min(1.0f, sin2_theta / cone.sin2);
    const float t_over_r = (local.z - s * sqrtf(1 - q)) / s;
    const float cos_alpha = sqrtf(sin2_theta * q) + local.z * sqrtf(1 - q);
    const Vec3 n =
        normalize(frame.to_world(Vec3(local.x * t_over_r, local.y * t_over_r, -cos_alpha)));
    const Vec3 p = sphere.center + sphere.radius * n;
    const float pdf = cone_pdf(cone.one_minus_cos);
    return {p, error, n, wi, length(p - from), radiance, pdf, false, pdf < infinity};
}

// The density of wi from `from`, which meets the sphere at p with normal n.
HD float sphere_light_pdf(const Sphere& sphere, Vec3 from, Vec3 wi, Vec3 p, Vec3 n) {
    const SphereCone cone = cone_around(sphere, from);
    if (cone.exists) return cone_pdf(cone.one_minus_cos);
    return solid_angle_pdf(sphere_area_pdf(sphere), length_squared(p - from), fabsf(dot(wi, n)));
}

} // namespace raylab
