// Tier 2: independent random numbers. Renders with seeds that nobody could know, compared with a
// reference that knows its own error, in every tile of 16 x 16 pixels, in every square of 2 x 2
// tiles and in the whole image.
//
// A suspicion (all tests of the first stage together at alpha) is only believed if the same region,
// with fresh seeds and twice the samples, differs again in the same direction (again at alpha). A
// correct render fails at most alpha^2 = 2.5e-7 of the time, and each stage's 5e-4 can be checked
// by simulation, which 1e-6 in one shot could not (tests/calibration_test.cpp does).
//
// After J. Jung, J. Hanika, C. Dachsbacher, "Detecting Bias in Monte Carlo Renderers using Welch's
// t-test", JCGT 9(2), 2020.
#pragma once

#include "grader/judge/honesty.h"
#include "grader/judge/screening.h"
#include "grader/judge/soundness.h"

#include <functional>
#include <optional>

namespace raylab {

// Renders the image under judgement. Must use the seed for every random number.
using RenderReplicate = std::function<Image(std::uint32_t seed, int spp)>;

struct IndependentOptions {
    int replicates = 16;
    int spp = 16;                 // of a replicate of the first stage
    std::uint32_t first_seed = 1; // seeds are first_seed, first_seed + 1, ...
    double alpha = 5e-4;          // of each stage
    ScreeningOptions screening;
};

struct IndependentResult {
    Verdict verdict;
    Soundness soundness; // of the first unsound replicate, or of the last
    Screening screening;
    std::optional<TestResult> second; // of screening.worst's region; present if it was needed
    double false_alarm_rate = 0;      // of a correct renderer, in both stages together
    // A uniform error of this size would have failed the first stage with 99 % probability.
    double detectable_relative_error = 0;
    Honesty honesty;
    Image mean; // over the replicates of the first stage, with variance: verdict.measured is of it
};

IndependentResult judge_independent(const RenderReplicate& render, const Image& reference,
                                    const IndependentOptions& options = {});

// The first stage alone, on replicates that are at hand: false-alarm rate options.alpha.
IndependentResult judge_replicates(const Replicates& replicates, const Image& reference,
                                   const IndependentOptions& options = {});

} // namespace raylab
