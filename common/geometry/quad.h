// Ray and quad: two triangles that share the diagonal v[0] v[2].
//
// Rounding of the corners makes every quad slightly warped. Seen from the side, its outline may
// even cross itself. Its two halves are triangles, which are flat, and no ray passes between them.
#pragma once

#include "common/geometry/triangle.h"

namespace raylab {

// The plane of the half v[0] v[1] v[2], or of the half v[0] v[2] v[3].
HD ExactPlane exact_plane(const Quad& quad, bool first_half) {
    return {DVec3(quad.v[0]), quad.half_normal[first_half ? 0 : 1]};
}

// Is p, a point of the quad, in the half v[0] v[1] v[2], to the right of the diagonal?
HD bool is_in_first_half(const Quad& quad, DVec3 p) {
    const DVec3 diagonal = DVec3(quad.v[2]) - DVec3(quad.v[0]);
    return dot(cross(DVec3(quad.normal), diagonal), p - DVec3(quad.v[0])) < 0;
}

//[ withhold 01
// t in (0, ray.t_max) at which the ray meets the quad, from either side. Edges belong to both
// neighbours.
HD bool intersect(const Quad& quad, const ShearedRay& ray, float& t) {
    const Corner a = ray(quad.v[0]), b = ray(quad.v[1]), c = ray(quad.v[2]), d = ray(quad.v[3]);
    const double error =
        edge_error(glm::max(glm::max(a.width, b.width), glm::max(c.width, d.width)),
                   glm::max(glm::max(a.size, b.size), glm::max(c.size, d.size)));
    const double ab = edge(a, b), bc = edge(b, c), cd = edge(c, d), da = edge(d, a),
                 ca = edge(c, a);
    bool in_first = encloses(ab, bc, ca, error), in_second = encloses(cd, da, -ca, error);
    if (!(in_first | in_second)) return false;
    if (in_first && is_close(ab, bc, ca, error))
        in_first = encloses_closely(ray, quad.v[0], quad.v[1], quad.v[2]);
    if (in_second && !in_first && is_close(cd, da, -ca, error))
        in_second = encloses_closely(ray, quad.v[0], quad.v[2], quad.v[3]);
    if (!(in_first | in_second)) return false;
    return intersect(exact_plane(quad, in_first), ray.ray, t);
}
//| namespace lab01 {
//| bool hit_triangle(const Triangle& triangle, const ShearedRay& ray, float& t); // task 1.2
//| }
//|
//| // A quad is two triangles that share a diagonal, and yours finds them.
//| HD bool intersect(const Quad& quad, const ShearedRay& ray, float& t) {
//|     const Triangle first = {{quad.v[0], quad.v[1], quad.v[2]}, quad.normal, -1, quad.tags};
//|     const Triangle second = {{quad.v[0], quad.v[2], quad.v[3]}, quad.normal, -1, quad.tags};
//|     return lab01::hit_triangle(first, ray, t) || lab01::hit_triangle(second, ray, t);
//| }
//]

// The same for a ray that is known to pass well inside a parallelogram: only t is computed.
HD bool intersect_inside(const Quad& quad, const Ray& ray, float& t) {
    return intersect(exact_plane(quad, true), ray, t);
}

} // namespace raylab
