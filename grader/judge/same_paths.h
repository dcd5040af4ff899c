// Tier 1: the same random numbers. A correct renderer with the keyed generator and the reference's
// seed traces the reference's own paths, so its pixels agree to rounding (factors may be multiplied
// in another order); at most a few paths in a million part company at an edge.
#pragma once

#include "common/image/image.h"
#include "grader/judge/soundness.h"

#include <functional>
#include <optional>

namespace raylab {

struct SamePathsOptions {
    double relative_tolerance = 1e-5; // of the larger of the two values
    double parted_paths = 4e-6;       // share of all paths that may part; at least one may
};

struct SamePathsResult {
    Verdict verdict;
    Soundness soundness;
    std::size_t differing_pixels = 0, allowed_pixels = 0;
    double largest_relative_difference = 0;
    int first_x = -1, first_y = -1; // first pixel that differs, in rows from the top
    Vec3 first_value{0}, first_reference{0};
};

// Both images of the same seed and spp (else: std::invalid_argument). A failure here does not mean
// that the image is wrong: a renderer with random numbers of its own is judged by tier 2.
SamePathsResult judge_same_paths(const Image& image, const Image& reference,
                                 const SamePathsOptions& options = {});

// Radiance of one sample of one pixel, followed over at most `depth` surfaces.
using SampleValue = std::function<Vec3(int x, int y, int sample, int depth)>;

struct FirstDifference {
    int x, y, sample, depth; // depth: the first surface at which the two paths differ, from 1
    Vec3 value, reference;
};

// Which sample of the pixel differs first, and at which surface. Nothing if all agree.
std::optional<FirstDifference> find_first_difference(int x, int y, int spp, int max_depth,
                                                     const SampleValue& value,
                                                     const SampleValue& reference,
                                                     const SamePathsOptions& options = {});

} // namespace raylab
