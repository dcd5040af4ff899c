// Up to sixteen quads side by side, and a first glance at all of them at once.
//
// A ray misses most quads of a room. The exact test is in double (quad.h). Float is enough to see
// that the ray passes far from a quad, and a compiler computes the same few operations for sixteen
// quads with one or two vector instructions. So a glance drops the quads that the ray certainly
// misses. For each of the others it tells from which t on the ray might meet it, and whether the
// ray certainly passes inside it.
//
// "For certain" is a bound on every rounding between the float computation and the exact one
// (Higham, section 3.1). A glance may keep a quad that the ray just misses; it never drops a quad
// that the ray meets.
#pragma once

#include "common/geometry/ray.h"

#include <cstdint>

namespace raylab {

constexpr int quads_per_group = 16;

// The quad of a lane lies in the parallelogram
//     { p : |normal.p - offset| <= bend,  0 <= across[i].p - start[i] <= 1,  i = 0, 1 }.
struct QuadGroup {
    int first, count; // SceneView::quads[first .. first + count) in lanes 0 .. count - 1
    float extent;     // the largest |coordinate| of their corners
    float normal[3][quads_per_group]; // unit
    float offset[quads_per_group];
    float bend[quads_per_group];         // bound on the distance of a corner from the plane
    float across[2][3][quads_per_group]; // unit: 1 / length
    float start[2][quads_per_group];
    float steepness[quads_per_group]; // the larger |x| + |y| + |z| of the two vectors `across`
    float vague[quads_per_group]; // 0 if the quad is the parallelogram, else infinity: never sure
};

// The position of the lowest bit that is set; bits != 0.
HD int lowest_bit(std::uint32_t bits) {
#if defined(__CUDA_ARCH__)
    return __ffs(static_cast<int>(bits)) - 1;
#else
    return __builtin_ctz(bits);
#endif
}

// What a glance saw: a bit for each lane.
struct QuadGlance {
    std::uint32_t maybe = 0;      // the ray may meet the quad of the lane
    std::uint32_t sure = 0;       // the ray certainly passes inside it: only t is left to compute
    float begin[quads_per_group]; // where it may meet the quad, a lower bound of t
};

// Where may `ray` meet the quads of the group in (0, t_max]?
//
// With M = max |o| + extent, |normal| <= 1 and |d| <= 1, each of |n.o|, |offset| and |t| is below
// sqrt(3) M, and the error of the computed slope s = n.d is at most 3 sqrt(3) u. Hence
//     |t - t_exact| <= (bend + 16 u M) / |s| + 3 u |t|,
//     |c_i - c_exact| <= steepness (14 u M + |t - t_exact|) + 8 u
// for the coordinates c_i = across[i].p - start[i]; the code doubles the constants. A ray in the
// plane of a quad gives NaN. Comparisons with NaN are false, and the code is written so that the
// lane then stays in `maybe`, and is not in `sure`.
HD_HOT QuadGlance glance(const QuadGroup& group, const Ray& ray, float t_max) {
    constexpr float u = unit_roundoff;
    const Vec3 o = ray.o, d = ray.d;
    const float size = max_component(abs(o)) + group.extent;
    QuadGlance seen;
    for (int k = 0; k < quads_per_group; ++k) {
        const float nx = group.normal[0][k], ny = group.normal[1][k], nz = group.normal[2][k];
        const float inv_slope = 1 / (nx * d.x + ny * d.y + nz * d.z);
        const float t = (group.offset[k] - (nx * o.x + ny * o.y + nz * o.z)) * inv_slope;
        const float t_error = (group.bend[k] + 32 * u * size) * fabsf(inv_slope) + 6 * u * fabsf(t);
        const float begin = t - t_error;

        const float px = o.x + t * d.x, py = o.y + t * d.y, pz = o.z + t * d.z;
        const auto& a = group.across;
        const float c0 = a[0][0][k] * px + a[0][1][k] * py + a[0][2][k] * pz - group.start[0][k];
        const float c1 = a[1][0][k] * px + a[1][1][k] * py + a[1][2][k] * pz - group.start[1][k];
        // How far (c0, c1) is outside of [0, 1]^2; negative inside.
        const float beyond0 = fabsf(c0 - 0.5f) - 0.5f, beyond1 = fabsf(c1 - 0.5f) - 0.5f;
        const float beyond = beyond0 > beyond1 ? beyond0 : beyond1;
        const float margin = group.steepness[k] * (28 * u * size + t_error) + 16 * u;

        const bool missed =
            (t + t_error < 0) | (begin > t_max) | (beyond > margin) | (k >= group.count);
        const bool inside = beyond < -margin - group.vague[k];
        seen.maybe |= std::uint32_t(!missed) << k;
        seen.sure |= std::uint32_t(inside) << k;
        seen.begin[k] = begin;
    }
    return seen;
}

} // namespace raylab
