// Two images, each with its own variance: do they show the same? This is what `raylab compare`
// does. The variance within each image must be relied on here, so its pixels are taken as
// independent; where replicates can be rendered, tier 2 (independent.h) is the better judge.
#pragma once

#include "grader/judge/metrics.h"
#include "grader/judge/moments.h"
#include "grader/judge/soundness.h"

#include <optional>

namespace raylab {

struct Comparison {
    Verdict verdict;
    bool decided = false;        // false where neither image has a variance, or one is unsound
    bool equal = false;          // bit for bit
    double false_alarm_rate = 0; // of calling two renders of the same scene different
    int tests = 0;               // regions x channels
    Region worst_region;
    int worst_channel = 0;            // 0 red, 1 green, 2 blue
    TestResult worst;                 // smallest p
    double worst_relative = 0;        // (a - b) / b there
    Metrics metrics;                  // of a against b, or against the reference if there is one
    std::optional<Metrics> metrics_b; // of b against the reference
    ZMap z_map;                       // of a against b
};

// passed means: not distinguishable. Each region's R, G and B by Welch's t, Bonferroni over all.
Comparison compare(const Image& a, const Image& b, const Image* reference = nullptr,
                   double alpha = 1e-3);

} // namespace raylab
