// Constants and the error bound of rounded arithmetic.
#pragma once

#include "common/math/hd.h"

#include <cmath>

namespace raylab {

constexpr float pi = 3.14159265358979323846f;
constexpr float two_pi = 2 * pi;
constexpr float inv_pi = 0.318309886183790671538f;
constexpr float inv_two_pi = 0.159154943091895335769f;
constexpr float infinity = __builtin_huge_valf();

// The largest float below 1: what a sampler returns at most.
constexpr float one_minus_epsilon = 0x1.fffffep-1f;

// Half an ulp of 1: a correctly rounded result is x (1 + delta) with |delta| <= unit_roundoff.
constexpr float unit_roundoff = 0x1p-24f;

// gamma(n) = n u / (1 - n u) bounds the relative error of n rounded operations in a row
// (Higham, Accuracy and Stability of Numerical Algorithms, section 3.1; PBR4e 6.8.1).
HD constexpr float gamma_bound(int n) { return n * unit_roundoff / (1 - n * unit_roundoff); }

HD float sqr(float x) { return x * x; }
// Comparisons instead of fminf and fmaxf, which cost a call on a CPU; a NaN becomes 0, or `low`.
HD float safe_sqrt(float x) { return sqrtf(x > 0 ? x : 0.0f); }
HD float clamp(float x, float low, float high) {
    const float y = x > low ? x : low;
    return y < high ? y : high;
}

} // namespace raylab
