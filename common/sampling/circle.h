// Points on the unit circle: cosine and sine of a fraction of a turn.
//
// Sampling needs angles 2 pi u. If angles are counted in turns, their reduction to the octant
// around an axis is exact. A short polynomial computes the rest, by sums and products alone. It
// gives the same bits on every machine that rounds correctly, and is faster than a sine of any
// angle.
#pragma once

#include "common/math/vec.h"

namespace raylab {

// (cos, sin) of t pi/4, |t| <= 1; absolute error below 1.5e-7. Polynomials in t^2 that interpolate
// sin(t pi/4) / t and (cos(t pi/4) - 1) / t^2 at Chebyshev's nodes, to 2.5e-9.
HD Vec2 cos_sin_octant(float t) {
    const float s = t * t;
    const float c =
        -0x1.3bd3ccp-2f + s * (0x1.03c1eap-6f + s * (-0x1.55cb98p-12f + s * 0x1.db6492p-19f));
    const float d =
        0x1.921fb6p-1f + s * (-0x1.4abbbap-4f + s * (0x1.465ec4p-9f + s * -0x1.2d9b4p-15f));
    return Vec2(1 + s * c, t * d);
}

// (cos, sin) of 2 pi u, |u| <= 2.
HD Vec2 cos_sin_turn(float u) {
    const int quarter = static_cast<int>(floorf(4 * u + 0.5f));
    const Vec2 p = cos_sin_octant(8 * u - 2 * quarter); // exact: a difference of near numbers
    const Vec2 q = quarter & 1 ? Vec2(-p.y, p.x) : p;
    return quarter & 2 ? -q : q;
}

} // namespace raylab
