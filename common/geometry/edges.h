// Hit points keep a few ulps away from the edges of their face.
//
// Rounding may put a hit on the floor of a room into the plane of the wall beside it, or behind. Of
// the rays that leave from there half would never meet that wall.
#pragma once

#include "common/geometry/plane.h"

namespace raylab {

// p, a point of the face with corners v in order, at least 16 u |p| from each of its edges; less if
// the face is so small that this is not inside it. Points farther away stay where they are.
template <int n> HD DVec3 clear_of_edges(const Vec3 (&v)[n], const ExactPlane& plane, DVec3 p) {
    const auto edge_from = [&](int i) { return DVec3(v[i + 1 < n ? i + 1 : 0]) - DVec3(v[i]); };
    double longest = 0; // squared
    for (int i = 0; i < n; ++i) longest = glm::max(longest, dot(edge_from(i), edge_from(i)));
    // |normal| is twice the area of half the face: a quarter of its height on the longest edge is
    // less than the radius of the circle it has room for.
    const double room = 0.25 * sqrt(dot(plane.normal, plane.normal) / longest);
    const double reach = glm::min(double(gamma_bound(16) * max_component(abs(Vec3(p)))), room);
    for (int i = 0; i < n; ++i) {
        const DVec3 inward = cross(plane.normal, edge_from(i));
        const double length = sqrt(dot(inward, inward));
        const double missing = reach * length - dot(inward, p - DVec3(v[i]));
        if (missing > 0) p += inward * (missing / (length * length));
    }
    return p;
}

} // namespace raylab
