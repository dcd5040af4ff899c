// The space in which triangles and quads are tested: the ray is the z axis.
// Woop, Benthin, Wald, Watertight Ray/Triangle Intersection, JCGT 2(1), 2013.
//
// A ray passes through a face if it passes all edges of the face on the same side. The side is
// computed in double from floats. If even double cannot decide it, the ray counts as on both sides.
// So a ray through an edge or a corner hits at least one of the faces around it.
//
// In float, the rounding of a large face's far corners would shift its edges. A ray that starts a
// few ulps above such a face, beside an edge, could miss both the face and its neighbour.
//
// The error of double grows with the distance of the face. Rays that pass far from a very small
// face would hit it by this error. So an edge that cannot be decided is tested again, with an error
// in proportion to its own length.
#pragma once

#include "common/geometry/ray.h"

namespace raylab {

// A corner in this space, in which the ray passes through (0, 0).
struct Corner {
    double x, y;
    double width, size; // |x| + |y|, and that plus the distance along the main axis
};

struct ShearedRay {
    Ray ray;
    int kx, ky, kz;   // a cyclic permutation of the axes; |d| is largest along kz
    float ox, oy, oz; // the origin, permuted
    double sx, sy;    // d.x / d.z and d.y / d.z, permuted: both within [-1, 1]

    HD explicit ShearedRay(const Ray& r) : ray(r) {
        const Vec3 size = abs(r.d);
        kz = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
        kx = kz == 2 ? 0 : kz + 1;
        ky = kx == 2 ? 0 : kx + 1;
        // Comparisons, because with an index a GPU would keep the ray in its slow local memory.
        const auto along = [](const Vec3& v, int k) { return k == 0 ? v.x : k == 1 ? v.y : v.z; };
        ox = along(r.o, kx), oy = along(r.o, ky), oz = along(r.o, kz);
        sx = along(r.d, kx) / double(along(r.d, kz));
        sy = along(r.d, ky) / double(along(r.d, kz));
    }

    // The corner moved along d into the plane z = o.z.
    HD Corner operator()(const Vec3& v) const {
        const float* p = &v.x;
        return sheared(double(p[kx]) - ox, double(p[ky]) - oy, double(p[kz]) - oz);
    }

    // The *way* from corner a to corner b: their difference, sheared likewise, and as exact as that
    // difference.
    HD Corner between(const Vec3& a, const Vec3& b) const {
        const float *p = &a.x, *q = &b.x;
        return sheared(double(q[kx]) - p[kx], double(q[ky]) - p[ky], double(q[kz]) - p[kz]);
    }

  private:
    HD Corner sheared(double x, double y, double z) const {
        x -= sx * z, y -= sy * z;
        const double width = fabs(x) + fabs(y);
        return {x, y, width, width + fabs(z)};
    }
};

// Twice the signed area of the triangle (ray, a, b). Its sign tells on which side of the edge a-b
// the ray passes.
HD double edge(const Corner& a, const Corner& b) { return a.x * b.y - a.y * b.x; }

// A bound on the rounding error of edge(), for corners of at most this width and size. Rounding
// moves x and y by less than 2^-51 size, with or without fused multiply-add, in any order of
// operations.
HD double edge_error(double width, double size) { return 0x1p-49 * width * size; }

// Does the ray pass the three edges of a triangle on the same side? An edge is undecided if |e| <=
// error; the ray then counts as passing it on both sides. If all three edges are undecided, the
// triangle is seen edge-on: the answer is no, and its neighbours are hit instead. There are no
// branches, because a CPU cannot predict which edge a ray misses.
HD bool encloses(double e0, double e1, double e2, double error) {
    const double least = glm::min(glm::min(e0, e1), e2), most = glm::max(glm::max(e0, e1), e2);
    return (least >= -error) != (most <= error);
}

// For a triangle that encloses() the ray: is one of its edges undecided?
HD bool is_close(double e0, double e1, double e2, double error) {
    const double least = glm::min(glm::min(e0, e1), e2), most = glm::max(glm::max(e0, e1), e2);
    return (least <= error) & (most >= -error);
}

// The same bound for an edge computed by its way: a x b = a x (b - a). The error of the way's x and
// y is less than 2^-51 times its own size. So an edge of length l is undecided only within
// l 2^-49 size, instead of width 2^-49 size.
HD double edge_error(const Corner& a, const Corner& way) {
    return 0x1p-49 * (a.size * way.width + a.width * way.size);
}

// encloses() with the edges computed by their ways. It is slower, and needed only if is_close().
// The ray is passed as a copy, so that the calling loops can keep their own ray in registers.
HD_RARE bool encloses_closely(ShearedRay ray, const Vec3& v0, const Vec3& v1, const Vec3& v2) {
    const Corner a = ray(v0), b = ray(v1), c = ray(v2);
    const Corner ab = ray.between(v0, v1), bc = ray.between(v1, v2), ca = ray.between(v2, v0);
    const double e0 = edge(a, ab), e1 = edge(b, bc), e2 = edge(c, ca);
    const double error0 = edge_error(a, ab), error1 = edge_error(b, bc), error2 = edge_error(c, ca);
    const bool right = (e0 >= -error0) & (e1 >= -error1) & (e2 >= -error2);
    const bool left = (e0 <= error0) & (e1 <= error1) & (e2 <= error2);
    return right != left;
}

} // namespace raylab
