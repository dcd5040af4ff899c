// Ray and plane, in double: grazing rays and origins next to the plane keep their digits.
#pragma once

#include "common/geometry/shapes.h"

namespace raylab {

// The plane through `point` across `normal` (any length but 0) in the precision that decides on
// which side of it a ray starts.
struct ExactPlane {
    DVec3 point, normal;
};

HD ExactPlane exact_plane(const Plane& plane) { return {DVec3(plane.point), DVec3(plane.normal)}; }

// t = n.(point - o) / n.d. The products of floats are exact, so the numerator's sign is right for
// any origin that float can tell from the plane. False if the ray is parallel (or the normal zero).
HD bool distance_to(const ExactPlane& plane, const Ray& ray, double& t) {
    const double slope = dot(plane.normal, DVec3(ray.d));
    if (slope == 0) return false;
    t = dot(plane.normal, plane.point - DVec3(ray.o)) / slope;
    return true;
}

// The point of the plane next to p.
HD DVec3 project(const ExactPlane& plane, DVec3 p) {
    const DVec3& n = plane.normal;
    return p - n * (dot(n, p - plane.point) / dot(n, n));
}

// t in (0, ray.t_max) at which the ray crosses the plane. Relative error of t: one rounding to
// float.
HD bool intersect(const Plane& plane, const Ray& ray, float& t) {
    double distance;
    if (!distance_to(exact_plane(plane), ray, distance)) return false;
    t = float(distance);
    return t > 0 && t < ray.t_max;
}

} // namespace raylab
