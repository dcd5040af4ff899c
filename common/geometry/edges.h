// Hit points are kept a few ulps away from the edges of their face.
//
// Rounding may put a hit point on the floor of a room into the plane of the wall beside it, or
// behind that plane. Half of the rays that leave from there would never meet the wall.
#pragma once

#include "common/geometry/plane.h"

namespace raylab {

// The clearance that p, a point of the face with corners v, must have from an edge, for each axis.
// In the direction of a unit vector n it is dot(clearance, |n|). It is a sum of three parts:
//
// 16 u of each coordinate, because the rounding of a coordinate is relative to this coordinate
// alone. 16 times `error`: p may be `error` off the face, and a ray starts twice as far above it.
// With this part, a neighbour that leans over the face at 10 degrees or more is still in front of
// the ray. And the rounding error, in double, of the plane of a neighbour as large as this face; it
// is the only part that is left where the coordinates are 0.
template <int n> HD DVec3 edge_clearance(const Vec3 (&v)[n], DVec3 p, float error) {
    const DVec3 lever = glm::abs(p - DVec3(v[2]));
    return double(gamma_bound(16)) * glm::abs(p) +
           (16.0 * error + 0x1p-48 * (lever.x + lever.y + lever.z));
}

// The point nearest to p that has this clearance from every edge, or as much clearance as the face
// has room for.
template <int n>
HD_RARE DVec3 moved_inside(const Vec3 (&v)[n], const ExactPlane& plane, DVec3 p, DVec3 clearance) {
    const auto edge_from = [&](int i) { return DVec3(v[i + 1 < n ? i + 1 : 0]) - DVec3(v[i]); };
    // A triangle holds a circle of radius 2 area / perimeter, which is at least 2 area / (3
    // longest). The larger half of a quad, with a diagonal of at most 2 longest, holds one of 2
    // area / (8 longest).
    DVec3 normal(0); // its length is 2 area
    double longest = 0;
    for (int i = 1; i + 1 < n; ++i) normal += cross(DVec3(v[i]) - DVec3(v[0]), edge_from(i));
    for (int i = 0; i < n; ++i) longest = glm::max(longest, glm::length(edge_from(i)));
    const double room = (n == 3 ? 0.25 : 0.1) * glm::length(normal) / longest;

    // For each edge: its unit normal in the face, and how far p has to move along this normal.
    DVec3 inward[n];
    double missing[n];
    for (int i = 0; i < n; ++i) {
        inward[i] = glm::normalize(cross(plane.normal, edge_from(i)));
        missing[i] =
            glm::min(dot(clearance, glm::abs(inward[i])), room) - dot(inward[i], p - DVec3(v[i]));
    }
    // The points with clearance form the face whose edges are moved inwards. The nearest of them to
    // p lies on a moved edge i with missing[i] > 0. For each such edge, the loop computes the part
    // from `from` to `to` that the other edges leave of it, and the place tau on this part that is
    // nearest to p. (At tau = 0 the edge is nearest to p.) Moving p off one edge after the other
    // would fail: in a sharp corner the second move undoes the first.
    DVec3 nearest = p;
    double least = infinity;
    for (int i = 0; i < n; ++i) {
        if (!(missing[i] > 0)) continue;
        const DVec3 along = glm::normalize(cross(plane.normal, inward[i]));
        double from = -infinity, to = infinity;
        for (int j = 0; j < n; ++j) {
            const double slope = dot(inward[j], along);
            const double left = missing[j] - missing[i] * dot(inward[j], inward[i]);
            if (j == i || slope == 0) continue;
            if (slope > 0)
                from = glm::max(from, left / slope);
            else
                to = glm::min(to, left / slope);
        }
        const double tau = glm::clamp(0.0, from, to);
        const double distance2 = missing[i] * missing[i] + tau * tau;
        if (from > to || !(distance2 < least)) continue;
        least = distance2;
        nearest = p + missing[i] * inward[i] + tau * along;
    }
    return nearest;
}

// Moves p, a point of the face with corners v in order, so that it has clearance from each edge. A
// point that has clearance already stays where it is. error: how far p may be off the face.
template <int n>
HD_HOT DVec3 clear_of_edges(const Vec3 (&v)[n], const ExactPlane& plane, DVec3 p, float error) {
    const auto edge_from = [&](int i) { return DVec3(v[i + 1 < n ? i + 1 : 0]) - DVec3(v[i]); };
    const DVec3 clearance = edge_clearance(v, p, error);
    bool clear = true;
    for (int i = 0; i < n; ++i) {
        const DVec3 inward = cross(plane.normal, edge_from(i)); // any length
        clear &= dot(inward, p - DVec3(v[i])) >= dot(clearance, glm::abs(inward));
    }
    return clear ? p : moved_inside(v, plane, p, clearance);
}

// Does p certainly have clearance from all edges of a parallelogram? This is a quick test. c0 and
// c1 in [0, 1] are the coordinates of p along the edges. The distance from the nearest edge is at
// least the smallest of c0, 1 - c0, c1, 1 - c1, divided by the steepness. No axis has more
// clearance than `most`, so no direction has more than sqrt(3) most. For a point with clearance the
// answer may still be no; then clear_of_edges() decides.
HD bool is_surely_clear_of_edges(const Quad& quad, DVec3 p, float error) {
    const Vec3 here(p), lever = abs(here - quad.v[2]);
    const float most = gamma_bound(16) * max_component(abs(here)) + 16 * error +
                       0x1p-48f * (lever.x + lever.y + lever.z);
    const DVec3 from_corner = p - DVec3(quad.v[0]);
    const double c0 = dot(quad.across[0], from_corner), c1 = dot(quad.across[1], from_corner);
    return glm::min(glm::min(c0, 1 - c0), glm::min(c1, 1 - c1)) > 2 * most * quad.steepness;
}

} // namespace raylab
