// Two pictures, each with what is known of its noise: do they show the same? This is what `raylab
// compare` does. The noise within each image, or between a few replicates, must be relied on here;
// where many replicates can be rendered, tier 2 (independent.h) is the better judge.
#pragma once

#include "grader/judge/moments.h"
#include "grader/judge/soundness.h"

#include <optional>

namespace raylab {

struct CompareOptions {
    double alpha = 1e-3; // of calling two renders of the same scene different
    bool exact = false;  // a single image without an error has no noise
};

struct Comparison {
    Verdict verdict;
    // false where noise and error cannot be told apart: the images differ by more than what is
    // known of their noise, and there is more that is not known. verdict.sentence says what would
    // decide.
    bool decided = false;
    bool equal = false; // bit for bit
    double false_alarm_rate = 0;
    int replicates_a = 1, replicates_b = 1;
    double shared_noise_a = 1, shared_noise_b = 1; // NoisyImage::shared_noise()
    int tests = 0;                                 // regions x channels
    Region worst_region;
    int worst_channel = 0;     // 0 red, 1 green, 2 blue
    TestResult worst;          // smallest p
    double worst_relative = 0; // (a - b) / b there
    Image mean_a, mean_b;      // over the replicates: verdict.measured is of a against b
    std::optional<Metrics> metrics_a, metrics_b; // against the reference, if there is one

    // Of a against the reference, or against b if there is none.
    Metrics metrics() const {
        return metrics_a ? *metrics_a : verdict.measured ? verdict.measured->metrics : Metrics{};
    }
};

// passed means: not distinguishable. Each region's R, G and B by Welch's t, Bonferroni over all.
// Either side is one image that knows its error, or replicates of different seeds.
Comparison compare(const Replicates& a, const Replicates& b, const Image* reference = nullptr,
                   const CompareOptions& options = {});

// The same for one image a side.
Comparison compare(const Image& a, const Image& b, const Image* reference = nullptr,
                   const CompareOptions& options = {});

} // namespace raylab
