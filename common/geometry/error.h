// Bounds on how far rounding puts a point off its shape, computed from the point's coordinates.
// PBR4e 6.8.1 (Floating-Point Arithmetic), 6.8.5 (Avoiding Intersections Behind Ray Origins).
#pragma once

#include "common/geometry/quad.h"
#include "common/geometry/sphere.h"

namespace raylab {

// The error along n: half an ulp of each coordinate from rounding p, and as much again from
// rounding an origin beside p.
HD_HOT float rounding_error(Vec3 p, Vec3 n) { return gamma_bound(2) * dot(abs(p), abs(n)); }

// On a plane, the rounding of the plane's equation in double is added. It grows with the distance
// from plane.point to p. conditioning: see normal_conditioning(); 1 for a normal that is given.
HD_HOT float error_on_plane(const ExactPlane& plane, Vec3 p, Vec3 n, double conditioning) {
    const DVec3 lever = glm::abs(DVec3(p) - plane.point);
    return rounding_error(p, n) + float(0x1p-50 * conditioning * (lever.x + lever.y + lever.z));
}

// |e1| |e2| / |e1 x e2|, the factor by which the cross product magnifies a rounding error. It is 1
// if the edges at corner a meet at a right angle, and large for a thin triangle.
HD double normal_conditioning(Vec3 a, Vec3 b, Vec3 c) {
    const DVec3 e1 = DVec3(b) - DVec3(a), e2 = DVec3(c) - DVec3(a), n = cross(e1, e2);
    return sqrt(dot(e1, e1) / dot(n, n) * dot(e2, e2));
}

// On a sphere, the rounding in double of r^2 in its test and of a point center + r n is added.
HD float error_on_sphere(const Sphere& sphere, Vec3 p, Vec3 n) {
    return rounding_error(p, n) + float(0x1p-50 * sphere.radius);
}

} // namespace raylab
