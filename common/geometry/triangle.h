// Ray and triangle: no ray passes between two triangles that share an edge.
// Woop, Benthin, Wald, Watertight Ray/Triangle Intersection, JCGT 2(1), 2013.
#pragma once

#include "common/geometry/plane.h"
#include "common/geometry/sheared_ray.h"

namespace raylab {

// The plane of a triangle; the length of its normal is 2 area. In double, differences of floats and
// their products are (nearly) exact.
HD ExactPlane plane_through(Vec3 a, Vec3 b, Vec3 c) {
    return {DVec3(a), cross(DVec3(b) - DVec3(a), DVec3(c) - DVec3(a))};
}

HD ExactPlane exact_plane(const Triangle& triangle) {
    return plane_through(triangle.v[0], triangle.v[1], triangle.v[2]);
}

//[ withhold 01
// t in (0, ray.t_max) at which the ray meets the triangle, from either side. An edge or corner
// belongs to every triangle that has it. A triangle without area, or with a NaN in it, is never
// hit.
HD bool intersect(const Triangle& triangle, const ShearedRay& ray, float& t) {
    const Corner a = ray(triangle.v[0]), b = ray(triangle.v[1]), c = ray(triangle.v[2]);
    const double error = edge_error(glm::max(glm::max(a.width, b.width), c.width),
                                    glm::max(glm::max(a.size, b.size), c.size));
    const double ab = edge(a, b), bc = edge(b, c), ca = edge(c, a);
    if (!encloses(ab, bc, ca, error)) return false;
    if (is_close(ab, bc, ca, error) &&
        !encloses_closely(ray, triangle.v[0], triangle.v[1], triangle.v[2]))
        return false;
    return intersect(exact_plane(triangle), ray.ray, t);
}
//]

} // namespace raylab
