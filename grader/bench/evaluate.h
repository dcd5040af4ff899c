// From runs to figures: times, errors, whether the images agree at all, and only then ratios.
#pragma once

#include "grader/bench/rounds.h"
#include "grader/bench/row.h"

namespace raylab::bench {

struct EvaluateOptions {
    Plan plan;
    std::string baseline;         // a contestant's name
    double target_rel_mse = 0.01; // for seconds_to_target
};

// `reference`: of the same scene and size, or nullptr. Without a reference, errors come from pairs
// of rounds, and the images are judged against the first contestant that did not fail.
//
// Two images agree if the judge's first stage passes (false-alarm rate 5e-4) and the mean luminance
// is within 0.5 % beyond its 99.9 % interval.
std::vector<Row> evaluate(const std::vector<Turns>& turns, const Image* reference,
                          const EvaluateOptions& options);

} // namespace raylab::bench
