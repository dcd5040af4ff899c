// Where does a ray meet a sphere?
//
// With f = o - center, |o + t d - center|^2 = r^2 is the quadratic  a t^2 - 2 b t + c = 0,
//     a = d.d,   b = -f.d,   c = f.f - r^2.
// The textbook's b^2 - a c subtracts two large numbers that nearly agree, and far away spheres fray.
// Comparing r with the distance of the line from the centre does not (Haines, Gunther, Akenine-Moller,
// Precision Improvements for Ray/Sphere Intersection, Ray Tracing Gems ch. 7, 2019).
#pragma once

#include "common/geometry/shapes.h"
#include "common/task/not_implemented.h"

namespace raylab::lab01 {

// The smallest t in (0, ray.t_max) at which the ray meets the sphere, from outside or inside.
inline bool hit_sphere(const Sphere& sphere, const Ray& ray, float& t) {
    //[ task 1.2
    const Vec3 f = ray.o - sphere.center;
    const float a = dot(ray.d, ray.d);
    const float b = -dot(f, ray.d);
    const float c = dot(f, f) - sqr(sphere.radius);
    const bool inside = c < 0;
    if (!inside && b <= 0) return false; // outside, and not coming nearer

    const Vec3 nearest = f + (b / a) * ray.d; // of the line to the centre, seen from there
    const float discriminant =
        inside ? b * b / a - c : sqr(sphere.radius) - dot(nearest, nearest);
    if (discriminant < 0) return false;

    // Of the two roots the larger has no cancellation; the smaller follows from t0 t1 = c / a.
    const float q = b + copysignf(sqrtf(a * discriminant), b);
    const float t0 = c / q, t1 = q / a;
    const float near_t = std::min(t0, t1), far_t = std::max(t0, t1);
    t = near_t > 0 ? near_t : far_t;
    return t > 0 && t < ray.t_max;
    //| not_implemented("1.2", "hit_sphere()");
    //| return false;
    //]
}

} // namespace raylab::lab01
