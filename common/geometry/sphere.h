// Ray and sphere in float, without the two cancellations of the textbook formula.
// Haines, Gunther, Akenine-Moller, Precision Improvements for Ray/Sphere Intersection, Ray Tracing
// Gems ch. 7, 2019; roots as in Press et al., Numerical Recipes 5.6.
#pragma once

#include "common/geometry/shapes.h"

namespace raylab {

// The smallest t in (0, ray.t_max) at which the ray meets the sphere, from outside or inside.
// With f = o - center the quadratic is a t^2 - 2 b t + c = 0. A ray aimed within 4 u D / r of the
// tangent (D: distance, r: radius) may be taken for either side of it.
HD bool intersect(const Sphere& sphere, const Ray& ray, float& t) {
    const Vec3 f = ray.o - sphere.center;
    const float a = dot(ray.d, ray.d);
    const float b = -dot(f, ray.d);
    const float c = dot(f, f) - sqr(sphere.radius);
    const bool inside = c < 0;
    if (!inside && b <= 0) return false; // outside and not approaching

    // a^-1 times a quarter of the discriminant. From outside b^2 - a c is a small difference of
    // large numbers, while r^2 - |f + (b/a) d|^2 compares the radius with the distance of the line
    // from the centre. From inside c < 0, and the two terms only add.
    const float discriminant =
        inside ? b * b / a - c : sqr(sphere.radius) - length_squared(f + (b / a) * ray.d);
    if (discriminant < 0) return false;

    // q is the root of larger magnitude times a: no cancellation; the product of the roots is c /
    // a.
    const float q = b + copysignf(sqrtf(a * discriminant), b);
    const float t0 = c / q, t1 = q / a;
    const float near_t = fminf(t0, t1), far_t = fmaxf(t0, t1);
    t = near_t > 0 ? near_t : far_t;
    return t > 0 && t < ray.t_max;
}

} // namespace raylab
