// Ray and quad: two triangles that share the diagonal v[0] v[2], and one plane.
#pragma once

#include "common/geometry/triangle.h"

namespace raylab {

HD ExactPlane exact_plane(const Quad& quad) {
    return plane_through(quad.v[0], quad.v[1], quad.v[3]);
}

// t in (0, ray.t_max) at which the ray meets the quad, from either side. Edges belong to both
// neighbours. The corners' rounding leaves no quad quite flat; seen edge-on it may even look like a
// bow tie. Halved along its diagonal it has no hole from anywhere.
HD bool intersect(const Quad& quad, const ShearedRay& ray, float& t) {
    const Corner a = ray(quad.v[0]), b = ray(quad.v[1]), c = ray(quad.v[2]), d = ray(quad.v[3]);
    const double error =
        edge_error(glm::max(glm::max(a.width, b.width), glm::max(c.width, d.width)),
                   glm::max(glm::max(a.size, b.size), glm::max(c.size, d.size)));
    const double diagonal = edge(c, a);
    const bool in_first = encloses(edge(a, b), edge(b, c), diagonal, error);
    const bool in_second = encloses(edge(c, d), edge(d, a), -diagonal, error);
    if (!(in_first | in_second)) return false;
    return hit_between(exact_plane(quad), ray.ray,
                       glm::min(glm::min(a.depth, b.depth), glm::min(c.depth, d.depth)),
                       glm::max(glm::max(a.depth, b.depth), glm::max(c.depth, d.depth)), t);
}

} // namespace raylab
