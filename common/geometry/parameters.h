// Coordinates on a shape: texture coordinates and barycentric weights of a point of it.
#pragma once

#include "common/geometry/shapes.h"

namespace raylab {

// u: the longitude of the point with unit normal n, from the x axis towards z, divided by 2 pi. v:
// its latitude, from the south pole (-y), divided by pi.
HD Vec2 sphere_uv(Vec3 n) {
    const float u = atan2f(n.z, n.x) * inv_two_pi;
    return Vec2(u < 0 ? u + 1 : u, acosf(clamp(-n.y, -1.0f, 1.0f)) * inv_pi);
}

// (u, v) with p = a + u (b - a) + v (c - a), for p in the plane of the three corners. u and v are
// ratios of areas.
HD Vec2 affine_coordinates(Vec3 a, Vec3 b, Vec3 c, DVec3 p) {
    const DVec3 e1 = DVec3(b) - DVec3(a), e2 = DVec3(c) - DVec3(a), n = cross(e1, e2);
    const DVec3 q = p - DVec3(a);
    return Vec2(dot(cross(q, e2), n) / dot(n, n), dot(cross(e1, q), n) / dot(n, n));
}

// (0, 0) at v[0], (1, 0) at v[1], (0, 1) at v[3]; (1, 1) at v[2] of a parallelogram.
HD Vec2 quad_uv(const Quad& quad, DVec3 p) {
    return affine_coordinates(quad.v[0], quad.v[1], quad.v[3], p);
}

// The weights of the three corners.
HD Vec3 barycentrics(const Triangle& triangle, DVec3 p) {
    const Vec2 b = affine_coordinates(triangle.v[0], triangle.v[1], triangle.v[2], p);
    return Vec3(1 - b.x - b.y, b.x, b.y);
}

} // namespace raylab
