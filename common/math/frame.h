// An orthonormal frame around a direction, without a branch and without a pole.
// Duff et al., Building an Orthonormal Basis, Revisited, JCGT 6(1), 2017.
#pragma once

#include "common/math/vec.h"

namespace raylab {

// Shading happens in a frame where the normal is z: cos(theta) of a local direction is its z.
struct Frame {
    Vec3 x, y, z;

    // n: unit vector. Frisvad's form divides by 1 + n.z and fails near n.z = -1; taking the sign of
    // n.z apart keeps the divisor in [1, 2].
    HD_HOT static Frame around(Vec3 n) {
        const float sign = copysignf(1.0f, n.z);
        const float a = -1.0f / (sign + n.z);
        const float b = n.x * n.y * a;
        return {Vec3(1 + sign * n.x * n.x * a, sign * b, -sign * n.x),
                Vec3(b, sign + n.y * n.y * a, -n.y), n};
    }

    HD_HOT Vec3 to_local(Vec3 v) const { return Vec3(dot(v, x), dot(v, y), dot(v, z)); }
    HD_HOT Vec3 to_world(Vec3 v) const { return x * v.x + y * v.y + z * v.z; }
};

} // namespace raylab
