// The space in which triangles and quads are tested: the ray is the z axis.
// Woop, Benthin, Wald, Watertight Ray/Triangle Intersection, JCGT 2(1), 2013.
//
// The ray passes a face if it passes its edges on the same side. Which side that is, is decided
// without error: in double, from floats, and where even double leaves it open the ray counts as on
// both sides. So of the faces around an edge or a corner, at least one is hit by a ray through it.
//
// In float the far corners of a large face shift its edges by their own rounding: a ray that starts
// a few ulps above such a face, beside an edge, could find neither it nor its neighbour.
#pragma once

#include "common/geometry/ray.h"

namespace raylab {

// A corner seen along the ray, which passes at (0, 0) and is level with it at t = depth.
struct Corner {
    double x, y, depth;
    double size; // at least the largest coordinate it was computed from
};

struct ShearedRay {
    Ray ray;
    int kx, ky, kz; // a cyclic permutation of the axes; d is largest along kz
    double sx, sy;  // d.x / d.z and d.y / d.z, permuted: both within [-1, 1]
    double inv_dz;

    HD explicit ShearedRay(const Ray& r) : ray(r) {
        const Vec3 size = abs(r.d);
        kz = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
        kx = kz == 2 ? 0 : kz + 1;
        ky = kx == 2 ? 0 : kx + 1;
        const float* d = &r.d.x;
        inv_dz = 1 / double(d[kz]);
        sx = d[kx] * inv_dz;
        sy = d[ky] * inv_dz;
    }

    // The corner moved along d into the plane z = o.z.
    HD Corner operator()(const Vec3& v) const {
        const float* p = &v.x;
        const float* o = &ray.o.x;
        const double z = double(p[kz]) - o[kz];
        const double x = (double(p[kx]) - o[kx]) - sx * z, y = (double(p[ky]) - o[ky]) - sy * z;
        return {x, y, z * inv_dz, fabs(x) + fabs(y) + fabs(z)};
    }
};

// Twice the signed area of (ray, a, b): on which side of the edge a-b the ray passes. Rounding
// moves x and y by less than 2^-50 size, and the area by less than 2^-49 size size; below that it
// is 0. The sign is never wrong, whether or not the compiler fuses or reorders the operations.
HD double edge(const Corner& a, const Corner& b) {
    const double area = a.x * b.y - a.y * b.x;
    return fabs(area) > 0x1p-49 * (a.size * b.size) ? area : 0;
}

// Three edges that turn the same way enclose the ray; one through the ray (0) turns both ways.
HD bool same_side(double a, double b, double c) {
    return (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0);
}

} // namespace raylab
