// How far a render is from the truth, in numbers that can be divided by time.
//
// Against a reference that knows its own variance, or, where there is none, from two renders with
// different seeds: E (a - b)^2 / 2 is the variance of one of them, whatever the truth. The second
// does not see bias, which is measured apart.
#pragma once

#include "common/image/image.h"

#include <vector>

namespace raylab::bench {

struct MeasuredError {
    double mse = 0;     // mean over pixels and channels, squared radiance
    double rel_mse = 0; // each divided by level^2 + (1 % of the mean level)^2, as in measure()
};

// mean((image - reference)^2 - var_reference). Without the last term, a render of many samples
// would be charged with the error of a reference of few. A reference without variance is taken as
// exact. Throws std::invalid_argument unless both have the same size; leaves out pixels that are
// not finite.
MeasuredError error_against(const Image& image, const Image& reference);

// mean((a - b)^2) / 2. Relative errors are relative to the radiance `level`, and not to a or b,
// whose noise they would follow.
MeasuredError error_of_pair(const Image& a, const Image& b, const Image& level);

// The difference of mean luminance, relative to the truth's, with the half width of its interval.
struct Bias {
    double relative = 0, half_width_95 = 0, half_width_999 = 0;
};

// From at least two renders with seeds of their own, by Welch's t. The error of the renders follows
// from their spread; the error of the truth is its variance, with pixels taken as independent.
Bias bias_of(const std::vector<const Image*>& renders, const Image& truth);

} // namespace raylab::bench
