// Hit points keep a few ulps away from the edges of their face.
//
// Rounding may put a hit on the floor of a room into the plane of the wall beside it, or behind. Of
// the rays that leave from there half would never meet that wall.
#pragma once

#include "common/geometry/plane.h"

namespace raylab {

// p moved inwards until it is `reach` from every edge, or as far as the face has room for.
template <int n>
HD DVec3 moved_inside(const Vec3 (&v)[n], const ExactPlane& plane, DVec3 p, double reach) {
    const auto edge_from = [&](int i) { return DVec3(v[i + 1 < n ? i + 1 : 0]) - DVec3(v[i]); };
    double longest = 0; // squared
    for (int i = 0; i < n; ++i) longest = glm::max(longest, dot(edge_from(i), edge_from(i)));
    // |normal| is twice the area of half the face: a quarter of its height on the longest edge is
    // less than the radius of the circle it has room for.
    const double room = 0.25 * sqrt(dot(plane.normal, plane.normal) / longest);
    reach = glm::min(reach, room);
    for (int i = 0; i < n; ++i) {
        const DVec3 inward = cross(plane.normal, edge_from(i));
        const double length = sqrt(dot(inward, inward));
        const double missing = reach * length - dot(inward, p - DVec3(v[i]));
        if (missing > 0) p += inward * (missing / (length * length));
    }
    return p;
}

// p, a point of the face with corners v in order, at least 16 u |p| from each of its edges; less if
// the face is so small that this is not inside it. Points farther away stay where they are.
template <int n> HD_HOT DVec3 clear_of_edges(const Vec3 (&v)[n], const ExactPlane& plane, DVec3 p) {
    const auto edge_from = [&](int i) { return DVec3(v[i + 1 < n ? i + 1 : 0]) - DVec3(v[i]); };
    const double reach = gamma_bound(16) * max_component(abs(Vec3(p)));
    // Distance d from an edge, times the length of the normal and the edge: compared in squares,
    // because nearly every point is clear and needs no root.
    bool clear = true;
    for (int i = 0; i < n; ++i) {
        const DVec3 inward = cross(plane.normal, edge_from(i));
        const double d = dot(inward, p - DVec3(v[i]));
        clear &= (d > 0) & (d * d >= reach * reach * dot(inward, inward));
    }
    return clear ? p : moved_inside(v, plane, p, reach);
}

// The same question for a parallelogram, by its own coordinates: c0 and c1 of p lie in [0, 1], and
// the distance from the nearest edge is at least the smallest of c0, 1 - c0, c1, 1 - c1 divided by
// the steepness. May say no to a point that is clear by less than twice what is needed.
HD bool is_clear_of_edges(const Quad& quad, DVec3 p) {
    const DVec3 from_corner = p - DVec3(quad.v[0]);
    const double c0 = dot(quad.across[0], from_corner), c1 = dot(quad.across[1], from_corner);
    const double nearest = glm::min(glm::min(c0, 1 - c0), glm::min(c1, 1 - c1));
    return nearest > 2 * gamma_bound(16) * max_component(abs(Vec3(p))) * quad.steepness;
}

} // namespace raylab
