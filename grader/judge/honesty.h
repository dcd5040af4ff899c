// Is the noise as large as it should be? Equal images for different seeds fail; everything else
// here is a hint, since a correct renderer may have more noise, or less, than the reference's.
#pragma once

#include "grader/judge/moments.h"

#include <optional>

namespace raylab {

struct Honesty {
    bool seed_ignored = false; // replicates are equal bit for bit where the reference has noise
    // Share of noise that two replicates have in common: 0 if independent, 1 if equal.
    double replicate_correlation = 0;
    // Variance of one sample over the reference's (median over tiles): low if cached or denoised,
    // high if a sampling technique is missing. Nothing if the reference has no variance.
    std::optional<double> variance_ratio;
    // Variance of tile means over that of independent pixels (median): high if neighbours share
    // their noise, as after a denoiser; below 1 if pixels are stratified against each other.
    double tile_ratio = 1;
    // Variance of the first stage over that of the second, which has twice the samples: 2, or more
    // for stratified samplers.
    std::optional<double> variance_fall;
    std::vector<std::string> hints;
};

Honesty check_honesty(const Replicates& first, const Image& reference,
                      const Replicates* second = nullptr);

} // namespace raylab
