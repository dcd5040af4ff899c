// The space in which triangles and quads are tested: the ray is the z axis.
// Woop, Benthin, Wald, Watertight Ray/Triangle Intersection, JCGT 2(1), 2013.
//
// A corner's place across the ray depends on the ray and on that corner alone, so two faces that
// share the corner's bits share its image too, and the image of a closed surface is closed. It is
// computed in double from floats: 29 bits finer than any coordinate of the scene. In float the
// image would be shifted by an ulp of the *farthest* corner, and a ray that starts a few ulps above
// a large face, beside its edge, could find neither that face nor its neighbour.
#pragma once

#include "common/geometry/ray.h"

namespace raylab {

// A corner seen along the ray: the ray passes at (0, 0) and is level with the corner at t = depth.
struct Corner {
    double x, y, depth;
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
        return {(double(p[kx]) - o[kx]) - sx * z, (double(p[ky]) - o[ky]) - sy * z, z * inv_dz};
    }
};

// Twice the signed area of (ray, a, b): on which side of the edge a-b the ray passes. 0 where the
// rounding of the two products leaves it open, so the sign is never wrong, whether or not the
// compiler fuses or reorders the operations.
HD double edge(const Corner& a, const Corner& b) {
    const double left = a.x * b.y, right = a.y * b.x, area = left - right;
    return fabs(area) > 0x1p-50 * (fabs(left) + fabs(right)) ? area : 0;
}

// Three edges that turn the same way enclose the ray; an edge through the ray (0) turns both ways.
HD bool same_side(double a, double b, double c) {
    return (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0);
}

} // namespace raylab
