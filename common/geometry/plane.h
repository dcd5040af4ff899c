// Ray and plane, in double, so that grazing rays and origins next to the plane lose no precision.
#pragma once

#include "common/geometry/shapes.h"

namespace raylab {

// The plane through `point`, perpendicular to `normal` (any length but 0). It is in double, because
// it decides on which side of the plane a ray starts.
struct ExactPlane {
    DVec3 point, normal;
};

HD ExactPlane exact_plane(const Plane& plane) { return {DVec3(plane.point), DVec3(plane.normal)}; }

// The point of the plane that is nearest to p.
HD_HOT DVec3 project(const ExactPlane& plane, DVec3 p) {
    const DVec3& n = plane.normal;
    return p - n * (dot(n, p - plane.point) / dot(n, n));
}

// t = n.(point - o) / n.d in (0, ray.t_max). Products of floats are exact in double, so a ray
// starts on the correct side of the plane wherever float can represent the difference. A parallel
// ray never hits, nor does any ray hit a plane whose normal is 0 or NaN.
HD_HOT bool intersect(const ExactPlane& plane, const Ray& ray, float& t) {
    const double slope = dot(plane.normal, DVec3(ray.d));
    if (slope == 0) return false;
    t = float(dot(plane.normal, plane.point - DVec3(ray.o)) / slope);
    return t > 0 && t < ray.t_max;
}

HD_HOT bool intersect(const Plane& plane, const Ray& ray, float& t) {
    return intersect(exact_plane(plane), ray, t);
}

} // namespace raylab
