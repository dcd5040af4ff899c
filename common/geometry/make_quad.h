// Makes a quad from its corners, and computes once what the test of every ray needs.
#pragma once

#include "common/geometry/error.h"

#include <algorithm>

namespace raylab {

// v: convex, in order around the edge, and flat up to rounding. The reader of scene files checks
// this. Host code only.
inline Quad make_quad(const Vec3 (&v)[4], ShapeTags tags) {
    const DVec3 e1 = DVec3(v[1]) - DVec3(v[0]), e2 = DVec3(v[3]) - DVec3(v[0]);
    Quad quad{{v[0], v[1], v[2], v[3]},
              Vec3(glm::normalize(cross(e1, e2))),
              tags,
              {},
              {},
              {},
              {},
              {},
              {}};
    quad.parallelogram = DVec3(v[0]) + e1 + e2 == DVec3(v[2]);
    const DVec3 height1 = e1 - e2 * (dot(e1, e2) / dot(e2, e2));
    const DVec3 height2 = e2 - e1 * (dot(e1, e2) / dot(e1, e1));
    quad.across[0] = height1 / dot(height1, height1);
    quad.across[1] = height2 / dot(height2, height2);
    quad.steepness =
        static_cast<float>(std::max(glm::length(quad.across[0]), glm::length(quad.across[1])));
    quad.half_normal[0] = plane_through(v[0], v[1], v[2]).normal;
    quad.half_normal[1] =
        quad.parallelogram ? quad.half_normal[0] : plane_through(v[0], v[2], v[3]).normal;
    quad.area = static_cast<float>(
        (glm::length(quad.half_normal[0]) + glm::length(quad.half_normal[1])) / 2);
    quad.conditioning[0] = static_cast<float>(normal_conditioning(v[0], v[2], v[1]));
    quad.conditioning[1] = quad.parallelogram
                               ? quad.conditioning[0]
                               : static_cast<float>(normal_conditioning(v[0], v[2], v[3]));
    return quad;
}

} // namespace raylab
