// The space in which triangles and quads are tested: the ray is the z axis.
// Woop, Benthin, Wald, Watertight Ray/Triangle Intersection, JCGT 2(1), 2013.
//
// A corner's place in the plane across the ray depends on the ray and on that corner alone, so two
// faces that share the corner's bits share its image too. On which side of an edge the ray passes is
// then decided exactly: no ray slips between neighbours.
#pragma once

#include "common/geometry/ray.h"

namespace raylab {

// A corner across the ray: the ray passes at (0, 0).
struct Corner {
    float x, y;
};

struct ShearedRay {
    Ray ray;
    int kx, ky, kz; // a cyclic permutation of the axes; d is largest along kz
    float sx, sy;   // d.x / d.z and d.y / d.z, permuted: both within [-1, 1]

    HD explicit ShearedRay(const Ray& r) : ray(r) {
        const Vec3 size = abs(r.d);
        kz = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
        kx = kz == 2 ? 0 : kz + 1;
        ky = kx == 2 ? 0 : kx + 1;
        const float* d = &r.d.x;
        sx = d[kx] / d[kz];
        sy = d[ky] / d[kz];
    }

    // The corner moved along d into the plane z = o.z.
    HD Corner operator()(const Vec3& v) const {
        const float* p = &v.x;
        const float* o = &ray.o.x;
        const float z = p[kz] - o[kz];
        return {p[kx] - o[kx] - sx * z, p[ky] - o[ky] - sy * z};
    }

    // The parameter t at which the ray is level with v along its main axis.
    HD double depth(const Vec3& v) const {
        return (double((&v.x)[kz]) - (&ray.o.x)[kz]) / (&ray.d.x)[kz];
    }
};

// Twice the signed area of (0, a, b): on which side of the edge a-b the ray passes. A product of two
// floats is exact in double (24 + 24 <= 53 bits), so the sign is that of the exact value, with or
// without fused multiply-add, and edge(a, b) = -edge(b, a).
HD double edge(Corner a, Corner b) {
    return double(a.x) * double(b.y) - double(a.y) * double(b.x);
}

// Three edges that turn the same way enclose the ray; an edge through the ray (0) turns both ways.
HD bool same_side(double a, double b, double c) {
    return (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0);
}

} // namespace raylab
