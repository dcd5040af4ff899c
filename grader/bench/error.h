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

// mean((image - reference)^2 - var_reference): with many samples a reference of few would otherwise
// be what is measured. A reference without variance is taken as exact. Same size, or
// std::invalid_argument; pixels that are not finite are left out.
MeasuredError error_against(const Image& image, const Image& reference);

// mean((a - b)^2) / 2; `level` is the radiance that errors are relative to: not a or b, whose noise
// it would follow.
MeasuredError error_of_pair(const Image& a, const Image& b, const Image& level);

// The difference of mean luminance, relative to the truth's, with the half width of its interval.
struct Bias {
    double relative = 0, half_width_95 = 0, half_width_999 = 0;
};

// From at least two renders with seeds of their own, by Welch's t: the error of the renders is how
// far they lie apart, that of the truth is its variance, pixels taken as independent.
Bias bias_of(const std::vector<const Image*>& renders, const Image& truth);

} // namespace raylab::bench
