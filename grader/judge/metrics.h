// Measures that are shown to people. No verdict depends on them.
#pragma once

#include "common/image/image.h"

namespace raylab {

struct Metrics {
    double mse = 0; // mean over pixels and channels of (a - r)^2
    // Mean of ((a - r)^2 - var_r) / (r^2 + e^2), e = 1 % of the reference's mean: the reference's
    // own noise is taken off. May be slightly negative.
    double rel_mse = 0;
    double rel_error = 0; // mean of a over mean of r, less 1, in luminance
    // sqrt(MSE - var_a - var_r) over the reference's mean: what noise does not explain. Needs the
    // error of every pixel of `image`; else NaN. 0 where noise explains all.
    double rel_bias = 0;
};

// Both of the same size (else: std::invalid_argument); pixels that are not finite in either are
// left out.
Metrics measure(const Image& image, const Image& reference);

// Signed z = (a - r) / sqrt(var_a + var_r) of each 16 x 16 tile's mean luminance, row by row; 0
// where both are equal, NaN where neither has an error or one has a pixel that does not know its
// own. The channels' noise is taken as fully correlated, so |z| is rather too small.
struct ZMap {
    int columns = 0, rows = 0, tile = 0;
    std::vector<double> z;
};
ZMap z_map(const Image& image, const Image& reference);

} // namespace raylab
