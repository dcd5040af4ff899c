// Up to four triangles side by side: what a leaf holds, and a first glance at all of them at once.
//
// Whether a ray meets a triangle is decided in double (common/geometry/triangle.h), and that
// decision is the image. Most triangles of a leaf are missed so clearly that float shows it, and a
// compiler does the same few operations for four of them in one instruction. So the glance drops
// those that the ray misses for certain, and hands on the rest.
#pragma once

#include "common/geometry/sheared_ray.h"

#include <cstdint>

namespace raylab::lab04 {

constexpr int triangles_per_block = 4;

struct TriangleBlock {
    float v[3][3][triangles_per_block]; // corner, axis, lane
    int index[triangles_per_block];     // in SceneView::triangles; -1: the lane is empty
};

// The ray of a glance: ShearedRay's axes, in float.
struct GlanceRay {
    float ox, oy, oz; // the origin, permuted
    float sx, sy;     // slopes d.x / d.z, d.y / d.z, permuted: both within [-1, 1]
    float inv_dz;     // t = z * inv_dz at the depth z along the main axis

    HD explicit GlanceRay(const ShearedRay& ray)
        : ox(ray.ox), oy(ray.oy), oz(ray.oz), sx(float(ray.sx)), sy(float(ray.sy)),
          inv_dz(1 / (ray.kz == 0   ? ray.ray.d.x
                      : ray.kz == 1 ? ray.ray.d.y
                                    : ray.ray.d.z)) {}
};

// A bit for each lane whose triangle the ray may meet in (0, t_max].
//
// With size = |x| + |y| + |z| of a corner in ray space, x and y are off by less than 4 u size (the
// subtraction, the slope, its product, the last subtraction), an edge function of two corners by
// less than 11 u width size, where width = |x| + |y|: 2^-20 = 16 u bounds that, and what double
// leaves open besides. On the triangle t lies between those of its corners, (p - o).z inv_dz, with
// three roundings. A NaN drops its triangle, which is never hit.
HD_HOT std::uint32_t glance(const TriangleBlock& block, const ShearedRay& axes,
                            const GlanceRay& ray, float t_max) {
    constexpr int lanes = triangles_per_block;
    const auto& [a, b, c] = block.v;
    const float room = 1 + 2 * gamma_bound(3);
    std::uint32_t maybe = 0;
    for (int k = 0; k < lanes; ++k) {
        const float az = a[axes.kz][k] - ray.oz, bz = b[axes.kz][k] - ray.oz,
                    cz = c[axes.kz][k] - ray.oz;
        const float ax = a[axes.kx][k] - ray.ox - ray.sx * az,
                    ay = a[axes.ky][k] - ray.oy - ray.sy * az,
                    bx = b[axes.kx][k] - ray.ox - ray.sx * bz,
                    by = b[axes.ky][k] - ray.oy - ray.sy * bz,
                    cx = c[axes.kx][k] - ray.ox - ray.sx * cz,
                    cy = c[axes.ky][k] - ray.oy - ray.sy * cz;
        const auto larger = [](float x, float y) { return x > y ? x : y; };
        const auto smaller = [](float x, float y) { return x < y ? x : y; };
        const float aw = fabsf(ax) + fabsf(ay), bw = fabsf(bx) + fabsf(by),
                    cw = fabsf(cx) + fabsf(cy);
        const float width = larger(larger(aw, bw), cw);
        const float depth = larger(larger(fabsf(az), fabsf(bz)), fabsf(cz));
        const float margin = 0x1p-20f * width * (width + depth);

        const float e0 = ax * by - ay * bx, e1 = bx * cy - by * cx, e2 = cx * ay - cy * ax;
        const float least = smaller(smaller(e0, e1), e2), most = larger(larger(e0, e1), e2);
        const float ta = az * ray.inv_dz, tb = bz * ray.inv_dz, tc = cz * ray.inv_dz;
        const float begin = smaller(smaller(ta, tb), tc), end = larger(larger(ta, tb), tc);
        const bool met = ((least >= -margin) | (most <= margin)) & (end >= 0) &
                         (begin <= t_max * room) & (block.index[k] >= 0);
        maybe |= std::uint32_t(met) << k;
    }
    return maybe;
}

} // namespace raylab::lab04
