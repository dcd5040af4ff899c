// Tier 3: exact things. Whitted images, hit ids, normals and depths hold no noise: every value must
// be the reference's, except that at most one pixel in a thousand may hold a neighbour's, because
// rounding may decide an edge the other way.
#pragma once

#include "common/image/image.h"
#include "grader/judge/soundness.h"

namespace raylab {

struct ExactOptions {
    double absolute_tolerance = 1e-4;
    double relative_tolerance = 1e-3; // of the reference's value
    double edge_share = 1e-3;         // pixels that may hold a value of their 3x3 neighbourhood
};

struct ExactResult {
    Verdict verdict;
    Soundness soundness;             // images only
    std::size_t edge = 0, wrong = 0; // pixels
    std::size_t edge_allowed = 0;
    int first_x = -1, first_y = -1; // first wrong pixel, or first edge pixel if none is wrong
};

ExactResult judge_exact(const Image& image, const Image& reference,
                        const ExactOptions& options = {});

// Hit ids, width * height of them, compared for equality.
ExactResult judge_exact(const std::vector<int>& ids, const std::vector<int>& reference, int width,
                        int height, const ExactOptions& options = {});

} // namespace raylab
