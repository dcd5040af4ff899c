// Sphere lights. A receiver outside samples the cone of directions that the sphere fills,
// uniformly. Shirley, Wang and Zimmerman, Monte Carlo Techniques for Direct Lighting Calculations,
// 1996; PBR4e 6.2.4.
//
// Every direction in the cone meets the visible side of the sphere, so the only variance of the
// irradiance is that of the receiver's cosine. A receiver inside the sphere, or on it, has no such
// cone. For it, points on the sphere are sampled uniformly by area.
#pragma once

#include "common/geometry/error.h"
#include "common/light/light_sample.h"
#include "common/math/frame.h"
#include "common/sampling/warp.h"

namespace raylab {

// The cone that the sphere fills as seen from a point.
struct SphereCone {
    Vec3 axis;           // unit, to the center
    float one_minus_cos; // of the half angle, whose sine is radius / distance
    bool exists;         // false: `from` is inside, or on the surface up to rounding
};

HD SphereCone cone_around(const Sphere& sphere, Vec3 from) {
    const DVec3 d = sphere.center - DVec3(from);
    const double distance = sqrt(dot(d, d));
    const Vec3 axis(d / distance);
    // Rounding must not make a point of the surface count as outside. Its cone would be the half
    // space in front of it, and the nearest point of the sphere would be the point itself.
    const double margin = sphere.radius + 4 * error_on_sphere(sphere, from, axis);
    if (!(distance > margin)) return {Vec3(0), 1, false};
    const double s = sphere.radius / distance;
    return {axis, one_minus_cos(float(s * s)), true};
}

HD float sphere_area_pdf(const Sphere& sphere) {
    return uniform_sphere_pdf / sqr(float(sphere.radius));
}

HD LightSample sample_sphere_light(const Sphere& sphere, Vec3 radiance, Vec3 from, Vec2 u) {
    const SphereCone cone = cone_around(sphere, from);
    if (!cone.exists) {
        const Vec3 n = sample_uniform_sphere(u);
        const Vec3 p(sphere.center + sphere.radius * glm::normalize(DVec3(n)));
        return light_sample_at(from, p, error_on_sphere(sphere, p, n), n, sphere_area_pdf(sphere),
                               radiance);
    }
    const Vec3 wi = Frame::around(cone.axis).to_world(sample_cone(u, cone.one_minus_cos));

    // p is the nearer point at which the line in direction wi meets the sphere, and n is the normal
    // there. `middle` is the point of the line that is nearest to the center, and p lies half a
    // chord in front of it. At the rim, rounding may make the line miss the sphere (chord2 < 0).
    // Then p is the point of the sphere that is nearest to the line.
    const DVec3 f = DVec3(from) - sphere.center, d(wi);
    const DVec3 middle = f - (dot(f, d) / dot(d, d)) * d;
    const double chord2 = (sphere.radius * sphere.radius - dot(middle, middle)) / dot(d, d);
    const DVec3 n = glm::normalize(middle - sqrt(glm::max(chord2, 0.0)) * d);
    const Vec3 p(sphere.center + sphere.radius * n);
    const float error = error_on_sphere(sphere, p, n), pdf = cone_pdf(cone.one_minus_cos);
    return {p, error, n, wi, length(p - from), radiance, pdf, false, pdf < infinity};
}

// The density with which sample_sphere_light() chooses wi for `from`. The ray in this direction
// meets the sphere at p, where the normal is n.
HD float sphere_light_pdf(const Sphere& sphere, Vec3 from, Vec3 wi, Vec3 p, Vec3 n) {
    const SphereCone cone = cone_around(sphere, from);
    if (cone.exists) return cone_pdf(cone.one_minus_cos);
    return solid_angle_pdf(sphere_area_pdf(sphere), length_squared(p - from), fabsf(dot(wi, n)));
}

} // namespace raylab
