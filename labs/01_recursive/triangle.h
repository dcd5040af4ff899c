// Where does a ray meet a triangle?
//
// Seen along the ray, the ray is the point (0, 0). It passes inside the triangle if it passes all
// three edges on the same side. An edge that cannot be decided counts as passed on both sides, so
// a ray through a shared edge hits one of its triangles (Woop, Benthin, Wald, JCGT 2(1), 2013).
#pragma once

#include "common/geometry/plane.h"
#include "common/geometry/sheared_ray.h"
#include "common/task/not_implemented.h"

#include <algorithm>

namespace raylab::lab01 {

// t in (0, ray.t_max) at which the ray meets the triangle, from either side.
inline bool hit_triangle(const Triangle& triangle, const ShearedRay& ray, float& t) {
    //[ task 1.2
    const Vec3* v = triangle.v;
    const Corner a = ray(v[0]), b = ray(v[1]), c = ray(v[2]);
    const double error =
        edge_error(std::max({a.width, b.width, c.width}), std::max({a.size, b.size, c.size}));
    const double ab = edge(a, b), bc = edge(b, c), ca = edge(c, a);
    if (!encloses(ab, bc, ca, error)) return false;
    // Decide close edges again by their lengths, or rays far from a tiny triangle would hit it.
    if (is_close(ab, bc, ca, error) && !encloses_closely(ray, v[0], v[1], v[2])) return false;

    // Where the ray crosses the triangle's plane: t = n.(v0 - o) / n.d.
    const DVec3 corner(v[0]), normal = cross(DVec3(v[1]) - corner, DVec3(v[2]) - corner);
    const double slope = dot(normal, DVec3(ray.ray.d));
    if (slope == 0) return false;
    t = static_cast<float>(dot(normal, corner - DVec3(ray.ray.o)) / slope);
    return t > 0 && t < ray.ray.t_max;
    //| not_implemented("1.2", "hit_triangle()");
    //| return false;
    //]
}

} // namespace raylab::lab01
