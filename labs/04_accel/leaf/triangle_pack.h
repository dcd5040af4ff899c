// Up to eight triangles side by side: what a leaf holds, and a first glance at all of them at once.
//
// Whether a ray meets a triangle is decided in double (common/geometry/triangle.h); the image
// depends on that alone. But most triangles of a leaf are missed so clearly that float is enough to
// tell, and a compiler does the few operations for eight triangles with one instruction each. So
// the glance drops the triangles that the ray misses for certain, and hands on the rest.
#pragma once

#include "common/geometry/ray.h"
#include "common/geometry/shapes.h"
#include "common/math/along.h"

#include <cstdint>

namespace raylab::lab04 {

// Eight cost a processor no more than four, and with leaves of eight a tree has half the nodes.
constexpr int triangles_per_pack = 8;

// Packs that so many triangles fill; the last may have empty lanes.
HD constexpr int packs_for(int triangles) {
    return (triangles + triangles_per_pack - 1) / triangles_per_pack;
}

struct TrianglePack {
    float v[3][3][triangles_per_pack]; // corner, axis, lane
    int index[triangles_per_pack];     // in SceneView::triangles; -1: the lane is empty
};

// The ray of a glance: along its main axis, as ShearedRay, but in float.
struct GlanceRay {
    int kx, ky, kz;   // a cyclic permutation of the axes; d is largest along kz
    float ox, oy, oz; // the origin, permuted
    float sx, sy;     // slopes d.x / d.z, d.y / d.z, permuted: both within [-1, 1]
    float inv_dz;     // t = z * inv_dz at the depth z along the main axis

    // inv_d: 1 / ray.d, rounded.
    HD_HOT GlanceRay(const Ray& ray, Vec3 inv_d) {
        const Vec3 size = abs(ray.d);
        kz = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
        kx = kz == 2 ? 0 : kz + 1;
        ky = kx == 2 ? 0 : kx + 1;
        ox = along(ray.o, kx), oy = along(ray.o, ky), oz = along(ray.o, kz);
        inv_dz = along(inv_d, kz);
        sx = along(ray.d, kx) * inv_dz;
        sy = along(ray.d, ky) * inv_dz;
    }
};

// What a glance saw: a bit for each lane.
struct TriangleGlance {
    std::uint32_t maybe = 0; // the ray may meet the lane's triangle, for a t within [begin, end]
    std::uint32_t sure = 0;  // it passes inside of it for certain
    float begin[triangles_per_pack], end[triangles_per_pack];
};

// Where may `ray` meet the triangles of the pack in (0, t_max]?
//
// All of it is float, with a bound on each error; u is the unit roundoff, 2^-24. A comparison with
// a NaN is false, and each one below is such that false keeps the triangle. errors: fewer than 16
// are for the test that shows that fewer are too few.
HD_HOT TriangleGlance glance(const TrianglePack& pack, const GlanceRay& ray, float t_max,
                             float errors = 16) {
    const auto larger = [](float x, float y) { return x > y ? x : y; };
    const auto smaller = [](float x, float y) { return x < y ? x : y; };
    // Below the normal numbers a product is off by 2^-150, whatever its size.
    constexpr float u = unit_roundoff, underflow = 0x1p-140f;
    const auto& [a, b, c] = pack.v;
    TriangleGlance seen;
    std::uint32_t missed = 0;
    for (int k = 0; k < triangles_per_pack; ++k) {
        const float az = a[ray.kz][k] - ray.oz, bz = b[ray.kz][k] - ray.oz,
                    cz = c[ray.kz][k] - ray.oz;
        // The corners in ray space, where the ray is the z axis. x and y are off by less than
        // 5 u (|x| + |y| + |z|): two subtractions, a slope with two roundings, and its product.
        const float ax = a[ray.kx][k] - ray.ox - ray.sx * az,
                    ay = a[ray.ky][k] - ray.oy - ray.sy * az,
                    bx = b[ray.kx][k] - ray.ox - ray.sx * bz,
                    by = b[ray.ky][k] - ray.oy - ray.sy * bz,
                    cx = c[ray.kx][k] - ray.ox - ray.sx * cz,
                    cy = c[ray.ky][k] - ray.oy - ray.sy * cz;
        const float width =
            larger(larger(fabsf(ax) + fabsf(ay), fabsf(bx) + fabsf(by)), fabsf(cx) + fabsf(cy));
        const float depth = larger(larger(fabsf(az), fabsf(bz)), fabsf(cz));
        // The edge functions ab, bc and ca are off by less than 13 u width (width + depth). 16
        // bounds that and also the rays for which double leaves it open on which side they pass.
        const float margin = errors * u * width * (width + depth) + underflow;

        const float ab = ax * by - ay * bx, bc = bx * cy - by * cx, ca = cx * ay - cy * ax;
        const float least = smaller(smaller(ab, bc), ca), most = larger(larger(ab, bc), ca);
        const float area = ab + bc + ca, inv_area = 1 / area;
        const bool inside = (larger(least, -most) > margin) & (fabsf(area) > 0x1p-100f);

        const float first = smaller(smaller(az, bz), cz), last = larger(larger(az, bz), cz);
        // The depth at which the ray meets the triangle's plane,
        //     z = (bc az + ca bz + ab cz) / (bc + ca + ab).
        // Inside, where all edge functions have the same sign, it is off by less than
        //     3 margin (last - first) / |area| + 8 u depth.
        const float z = bc * inv_area * az + ca * inv_area * bz + ab * inv_area * cz;
        // In this order no product underflows before it is divided.
        const float z_error = 4 * margin * fabsf(inv_area) * (last - first) + 12 * u * depth;
        // Near an edge, the ray may meet the triangle at any depth between those of the corners.
        const float from = inside ? z - z_error : first - 2 * u * depth;
        const float to = inside ? z + z_error : last + 2 * u * depth;
        // Along a negative axis the far end of the depths comes first.
        const float t0 = from * ray.inv_dz, t1 = to * ray.inv_dz;
        const float begin = smaller(t0, t1) * (1 - 4 * u), end = larger(t0, t1) * (1 + 4 * u);

        const bool passed_by = smaller(-least, most) > margin; // on both sides of an edge
        missed |= std::uint32_t(passed_by | (end < 0) | (begin > t_max) | (pack.index[k] < 0)) << k;
        seen.sure |= std::uint32_t(inside) << k;
        seen.begin[k] = begin;
        seen.end[k] = end;
    }
    seen.maybe = ~missed & ((1u << triangles_per_pack) - 1);
    return seen;
}

// The corners in a lane, without what else belongs to a triangle.
HD Triangle corners_in(const TrianglePack& pack, int lane) {
    Triangle triangle{};
    for (int corner = 0; corner < 3; ++corner)
        triangle.v[corner] = {pack.v[corner][0][lane], pack.v[corner][1][lane],
                              pack.v[corner][2][lane]};
    return triangle;
}

} // namespace raylab::lab04
