// From the unit square to disks, hemispheres, spheres, triangles and cones: uniform points u give
// points of the stated density. PBR4e A.5 (Sampling Multidimensional Functions).
//
// Every mapping is finite over the closed square and keeps neighbours together, so that points
// spread evenly in the square are spread evenly on the shape. Local directions: z is the normal or
// axis.
#pragma once

#include "common/math/numbers.h"
#include "common/sampling/circle.h"

namespace raylab {

// The square as [-1, 1]^2. A sample in [0, 1) stands for a cell of width 2^-24. Adding half a cell
// gives the cell's centre, which float holds exactly. So no point lies on the border or at 0.
HD Vec2 centred(Vec2 u) { return (2.0f * u - 1.0f) + 0x1p-24f; }

// Uniform on the unit disk, density 1/pi. Squares around the centre become circles (Shirley and
// Chiu, A Low Distortion Map Between Disk and Square, 1997): a's larger coordinate is the signed
// radius, the ratio of the two the angle, in eighths of a turn from that axis.
HD_HOT Vec2 sample_disk(Vec2 u) {
    const Vec2 a = centred(u);
    // A selection instead of a branch: a CPU cannot predict in which half of the square u lies.
    const bool wide = fabsf(a.x) > fabsf(a.y);
    const float radius = wide ? a.x : a.y, other = wide ? a.y : a.x;
    const Vec2 p = radius == 0 ? Vec2(0) : radius * cos_sin_octant(other / radius);
    return wide ? p : Vec2(p.y, p.x);
}

//[ withhold 01
// Upper hemisphere, density cos(theta)/pi: a disk's uniform points, lifted to the sphere (Malley).
HD_HOT Vec3 sample_cosine_hemisphere(Vec2 u) {
    const Vec2 d = sample_disk(u);
    const Vec2 a = centred(u);
    const float r =
        glm::max(fabsf(a.x), fabsf(a.y)); // |d| without rounding, and below 1: z stays positive
    return Vec3(d, sqrtf((1 - r) * (1 + r)));
}
//| namespace lab01 {
//| Vec3 sample_cosine(Vec2 u); // task 1.5
//| }
//|
//| // Upper hemisphere, density cos(theta)/pi: yours.
//| HD Vec3 sample_cosine_hemisphere(Vec2 u) { return lab01::sample_cosine(u); }
//]
HD float cosine_hemisphere_pdf(float cos_theta) { return glm::max(0.0f, cos_theta) * inv_pi; }

// All directions alike, density 1/(4 pi): the height of a uniform point on a sphere is uniform.
HD Vec3 sample_uniform_sphere(Vec2 u) {
    const float z = 1 - 2 * u.x;
    const float r = 2 * sqrtf(u.x * (1 - u.x)); // sqrt(1 - z^2) without its cancellation
    return Vec3(r * cos_sin_turn(u.y), z);
}
constexpr float uniform_sphere_pdf = inv_pi / 4;

// Barycentric coordinates (b0, b1, 1 - b0 - b1), uniform over any triangle, density 1/area. Folds
// the square over its diagonal (Heitz, A Low-Distortion Map Between Triangle and Square, 2019).
HD Vec2 sample_triangle(Vec2 u) {
    return u.y > u.x ? Vec2(u.x / 2, u.y - u.x / 2) : Vec2(u.x - u.y / 2, u.y / 2);
}

// A number in [0, 1] with density proportional to (1 - x) a + x b; a, b >= 0, not both 0. The
// inverse of the distribution function, in the form that does not cancel for a near b.
HD float sample_linear(float u, float a, float b) {
    const float p = a / (a + b), q = b / (a + b);
    return glm::min(1.0f, u / (p + sqrtf((1 - u) * p * p + u * q * q)));
}

// 1 - cos of an angle in [0, pi/2], from sin^2 of it. 1 - sqrt(1 - s2) loses every digit when the
// angle is small: 6.8 % at sin = 1e-3, a division by zero at 1e-4. This form is exact to rounding.
HD float one_minus_cos(float sin2) { return sin2 / (1 + safe_sqrt(1 - sin2)); }

// Uniform in the cone of directions around z with 1 - cos(theta) <= one_minus_cos_max; > 0.
HD Vec3 sample_cone(Vec2 u, float one_minus_cos_max) {
    const float v = u.x * one_minus_cos_max; // 1 - cos(theta)
    return Vec3(sqrtf(v * (2 - v)) * cos_sin_turn(u.y), 1 - v);
}
HD float cone_pdf(float one_minus_cos_max) { return inv_two_pi / one_minus_cos_max; }

} // namespace raylab
