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
    const Vec3* v = quad.v;
    const Corner a = ray(v[0]), b = ray(v[1]), c = ray(v[2]), d = ray(v[3]);
    const double diagonal = edge(c, a);
    if (!same_side(edge(a, b), edge(b, c), diagonal) &&
        !same_side(edge(c, d), edge(d, a), -diagonal))
        return false;
    const double d0 = ray.depth(v[0]), d1 = ray.depth(v[1]);
    const double d2 = ray.depth(v[2]), d3 = ray.depth(v[3]);
    return hit_within(exact_plane(quad), ray.ray, fmin(fmin(d0, d1), fmin(d2, d3)),
                      fmax(fmax(d0, d1), fmax(d2, d3)), t);
}

} // namespace raylab
