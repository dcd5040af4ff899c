// The shading normal of a triangle whose corners have normals of their own. It is interpolated, and
// then bent where wo would see its back. All vectors are unit.
#pragma once

#include "common/math/numbers.h"
#include "common/math/vec.h"

namespace raylab {

// The interpolated normal (Phong, 1975), turned to ng's side. b: the weights of the corners. The
// result is ng where the corners' normals cancel, or are NaN or infinite.
HD Vec3 interpolated_normal(const Vec3 (&normal)[3], Vec3 b, Vec3 ng) {
    const Vec3 n = b.x * normal[0] + b.y * normal[1] + b.z * normal[2];
    const float side = dot(n, ng), length2 = dot(n, n);
    if (!(side != 0 && length2 > 0 && length2 < infinity)) return ng;
    return normalize(copysignf(1.0f, side) * n);
}

// The normal nearest to n for which wo is on the same side as for ng. Near a silhouette wo may be
// in front of the face but behind n. With such a normal, an opaque surface would send light through
// itself, and glass would confuse outside and inside. s = 1 or -1 is wo's side of the face:
//   n' = normalize(n + s (c - s wo.n) wo),   c = min(|wo.ng|, 2^-10),   wherever s wo.n < c,
// which makes s wo.n' > 0. n' is continuous in wo, and not nearer to the plane of the face than n:
// n'.ng ~ n.ng + (c - s wo.n) |wo.ng|. Where rounding makes a sign wrong, the result is ng.
HD Vec3 facing_normal(Vec3 n, Vec3 ng, Vec3 wo) {
    const float cosine = dot(wo, ng), side = copysignf(1.0f, cosine);
    const float least = fabsf(cosine) < 0x1p-10f ? fabsf(cosine) : 0x1p-10f;
    const float seen = side * dot(wo, n);
    if (seen >= least) return n;
    const Vec3 bent = normalize(n + side * (least - seen) * wo);
    return side * dot(wo, bent) > 0 && dot(bent, ng) > 0 ? bent : ng;
}

} // namespace raylab
