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

// A corner seen along the ray, which passes at (0, 0).
struct Corner {
    double x, y;
    double width, size; // |x| + |y|, and that plus the distance along the main axis
};

struct ShearedRay {
    Ray ray;
    int kx, ky, kz;   // a cyclic permutation of the axes; d is largest along kz
    float ox, oy, oz; // the origin, permuted
    double sx, sy;    // d.x / d.z and d.y / d.z, permuted: both within [-1, 1]

    HD explicit ShearedRay(const Ray& r) : ray(r) {
        const Vec3 size = abs(r.d);
        kz = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
        kx = kz == 2 ? 0 : kz + 1;
        ky = kx == 2 ? 0 : kx + 1;
        // Selected, not indexed: an index would put the ray into a GPU's slow local memory.
        const auto along = [](const Vec3& v, int k) { return k == 0 ? v.x : k == 1 ? v.y : v.z; };
        ox = along(r.o, kx), oy = along(r.o, ky), oz = along(r.o, kz);
        sx = along(r.d, kx) / double(along(r.d, kz));
        sy = along(r.d, ky) / double(along(r.d, kz));
    }

    // The corner moved along d into the plane z = o.z.
    HD Corner operator()(const Vec3& v) const {
        const float* p = &v.x;
        const double z = double(p[kz]) - oz;
        const double x = (double(p[kx]) - ox) - sx * z, y = (double(p[ky]) - oy) - sy * z;
        const double width = fabs(x) + fabs(y);
        return {x, y, width, width + fabs(z)};
    }
};

// Twice the signed area of (ray, a, b): on which side of the edge a-b the ray passes.
HD double edge(const Corner& a, const Corner& b) { return a.x * b.y - a.y * b.x; }

// What rounding can make of an edge between corners no larger than this: it moves x and y by less
// than 2^-51 size, with or without fused multiply-add, in any order of operations.
HD double edge_error(double width, double size) { return 0x1p-49 * width * size; }

// Does the ray pass the three edges of a triangle on the same side? An edge too close to call is
// passed on both; a triangle of three such edges is seen edge-on and left to its neighbours.
// Without branches, because which edge a ray misses is as good as random.
HD bool encloses(double e0, double e1, double e2, double error) {
    const double least = glm::min(glm::min(e0, e1), e2), most = glm::max(glm::max(e0, e1), e2);
    return (least >= -error) != (most <= error);
}

} // namespace raylab
