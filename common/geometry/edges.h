// Hit points are kept a few ulps away from the edges of their face.
//
// Rounding may put a hit point on the floor of a room into the plane of the wall beside it, or
// behind that plane. Half of the rays that leave from there would never meet the wall.
#pragma once

#include "common/geometry/plane.h"

namespace raylab {

// How far p, a point of the face with corners v, is to stay from an edge, axis by axis: in the
// direction of the unit vector n that is dot(clearance, |n|).
//
// 16 u of each coordinate, because that one is rounded by it and no other is. 16 times `error`, by
// which p may be off the face and twice which a ray starts above it: a neighbour that leans over
// the face, at 10 degrees or more, is still in front of that ray. And what the plane of a neighbour
// as large as this face loses in double, which is all where the coordinates are 0.
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
    // A triangle has room for a circle of radius 2 area / perimeter, at least 2 area / (3 longest);
    // the larger half of a quad, with a diagonal of at most 2 longest, for 2 area / (8 longest).
    DVec3 normal(0); // 2 area long
    double longest = 0;
    for (int i = 1; i + 1 < n; ++i) normal += cross(DVec3(v[i]) - DVec3(v[0]), edge_from(i));
    for (int i = 0; i < n; ++i) longest = glm::max(longest, glm::length(edge_from(i)));
    const double room = (n == 3 ? 0.25 : 0.1) * glm::length(normal) / longest;

    // The unit normal of each edge in the face, and how far p is to move along it.
    DVec3 inward[n];
    double missing[n];
    for (int i = 0; i < n; ++i) {
        inward[i] = glm::normalize(cross(plane.normal, edge_from(i)));
        missing[i] =
            glm::min(dot(clearance, glm::abs(inward[i])), room) - dot(inward[i], p - DVec3(v[i]));
    }
    // The points with clearance are the face with each edge moved inwards; the one next to p lies
    // on such an edge of which p misses something. Edge by edge: what the other edges leave of this
    // one, from `from` to `to` along it, and of that the place next to p, where tau is 0. (One edge
    // after the other would not do: in a sharp corner the second push undoes the first.)
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

// p, a point of the face with corners v in order, with clearance from each of its edges. Points
// that have it stay where they are. error: how far p may be off the face.
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

// The same question for a parallelogram, asked quickly: by its own coordinates, c0 and c1 of p in
// [0, 1], the distance from the nearest edge is at least the smallest of c0, 1 - c0, c1, 1 - c1
// divided by the steepness. No axis has more clearance than `most`, so no direction has more than
// sqrt(3) most. The answer for a clear point may be no; clear_of_edges() then decides.
HD bool is_surely_clear_of_edges(const Quad& quad, DVec3 p, float error) {
    const Vec3 here(p), lever = abs(here - quad.v[2]);
    const float most = gamma_bound(16) * max_component(abs(here)) + 16 * error +
                       0x1p-48f * (lever.x + lever.y + lever.z);
    const DVec3 from_corner = p - DVec3(quad.v[0]);
    const double c0 = dot(quad.across[0], from_corner), c1 = dot(quad.across[1], from_corner);
    return glm::min(glm::min(c0, 1 - c0), glm::min(c1, 1 - c1)) > 2 * most * quad.steepness;
}

} // namespace raylab
