// How far rounding can put a point off its shape: bounds from the coordinates at hand.
// PBR4e 6.8.1 (Floating-Point Arithmetic), 6.8.5 (Avoiding Intersections Behind Ray Origins).
#pragma once

#include "common/geometry/quad.h"
#include "common/geometry/sphere.h"

namespace raylab {

// Along n: half an ulp a coordinate from rounding p, and as much from rounding an origin beside p.
HD_HOT float rounding_error(Vec3 p, Vec3 n) { return gamma_bound(2) * dot(abs(p), abs(n)); }

// On a plane besides: the rounding of the plane's equation, in double, between p and the point that
// anchors it. conditioning: see normal_conditioning; 1 for a normal that is given.
HD_HOT float error_on_plane(const ExactPlane& plane, Vec3 p, Vec3 n, double conditioning) {
    const DVec3 lever = glm::abs(DVec3(p) - plane.point);
    return rounding_error(p, n) + float(0x1p-50 * conditioning * (lever.x + lever.y + lever.z));
}

// |e1| |e2| / |e1 x e2|, by which the cross product magnifies a rounding error: 1 where the edges
// at a meet at a right angle, large for a needle.
HD double normal_conditioning(Vec3 a, Vec3 b, Vec3 c) {
    const DVec3 e1 = DVec3(b) - DVec3(a), e2 = DVec3(c) - DVec3(a), n = cross(e1, e2);
    return sqrt(dot(e1, e1) / dot(n, n) * dot(e2, e2));
}

// On a sphere besides: the rounding, in double, of its test's r^2 and of a point center + r n.
HD float error_on_sphere(const Sphere& sphere, Vec3 p, Vec3 n) {
    return rounding_error(p, n) + float(0x1p-50 * sphere.radius);
}

} // namespace raylab
