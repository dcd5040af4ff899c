// Where does a ray meet a sphere?
//
// With f = o - center, |o + t d - center|^2 = r^2 is the quadratic  a t^2 - 2 b t + c = 0,
//     a = d.d,   b = -f.d,   c = f.f - r^2.
// The textbook's b^2 - a c subtracts two large numbers that nearly agree, and far spheres get rough
// edges. The distance of the line from the centre, compared with r, has no such cancellation
// (Haines, Gunther, Akenine-Moller, Precision Improvements for Ray/Sphere Intersection, Ray Tracing
// Gems ch. 7, 2019). The terms are rounded too, so they are computed in double, which costs a CPU
// nothing: t is then correct to the last bit.
#pragma once

#include "common/geometry/shapes.h"
#include "common/task/not_implemented.h"

#include <algorithm>

namespace raylab::lab01 {

// The smallest t in (0, ray.t_max) at which the ray meets the sphere, from outside or inside.
inline bool hit_sphere(const Sphere& sphere, const Ray& ray, float& t) {
    //[ task 1.2
    const DVec3 f = DVec3(ray.o) - sphere.center, d(ray.d);
    const double r = sphere.radius;
    const double a = dot(d, d), b = -dot(f, d), c = dot(f, f) - r * r;

    const double middle = b / a; // t of the line's point nearest to the centre
    const DVec3 nearest = f + middle * d;
    const bool inside = c < 0; // the discriminant is then a sum: nothing cancels, and it is above 0
    const double discriminant = inside ? b * middle - c : r * r - dot(nearest, nearest);
    if (discriminant < 0) return false;

    // Of the two roots the larger has no cancellation; the smaller follows from t0 t1 = c / a.
    const double q = b + std::copysign(std::sqrt(a * discriminant), b);
    const double t0 = c / q, t1 = q / a;
    const float near_t = static_cast<float>(std::min(t0, t1));
    const float far_t = static_cast<float>(std::max(t0, t1));
    t = near_t > 0 ? near_t : far_t;
    return t > 0 && t < ray.t_max;
    //| not_implemented("1.2", "hit_sphere()");
    //| return false;
    //]
}

} // namespace raylab::lab01
