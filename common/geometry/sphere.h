// Ray and sphere without the two cancellations of the textbook formula.
// Haines, Gunther, Akenine-Moller, Precision Improvements for Ray/Sphere Intersection, Ray Tracing
// Gems ch. 7, 2019; roots as in Press et al., Numerical Recipes 5.6.
//
// These two methods remove the cancellation between terms. The rounding of the terms remains, so
// the test is in double. On a CPU double costs nothing, and t is exact up to one rounding to float.
#pragma once

#include "common/geometry/shapes.h"

namespace raylab {

//[ withhold 01
// The smallest t in (0, ray.t_max) at which the ray meets the sphere, from outside or inside.
HD bool intersect(const Sphere& sphere, const Ray& ray, float& t) {
    // a t^2 - 2 b t + c = 0 with f from the centre to the origin; c < 0 inside.
    const DVec3 f = DVec3(ray.o) - sphere.center, d(ray.d);
    const double r = sphere.radius;
    const double a = dot(d, d), b = -dot(f, d), c = dot(f, f) - r * r;

    // discriminant = b^2 / a - c. From far away it is a small difference of large numbers, so it is
    // computed as r^2 minus the squared distance of the line from the centre. From inside, c < 0,
    // the two terms add, and the ray certainly hits.
    const double middle = b / a;
    const DVec3 nearest = f + middle * d;
    const double discriminant = c < 0 ? b * middle - c : r * r - dot(nearest, nearest);
    if (discriminant < 0) return false;

    // q / a is the root of larger magnitude. The product of both roots is c / a, so the other is c
    // / q.
    const double q = b + copysign(sqrt(a * discriminant), b);
    const double t0 = c / q, t1 = q / a;
    const float near_t = float(t0 < t1 ? t0 : t1), far_t = float(t0 < t1 ? t1 : t0);
    t = near_t > 0 ? near_t : far_t;
    return t > 0 && t < ray.t_max;
}
//]

} // namespace raylab
