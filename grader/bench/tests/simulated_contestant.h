// A contestant that needs no time. Its image is the known truth with noise of a known size, and its
// seconds are those that the test sets.
#pragma once

#include "grader/bench/evaluate.h"
#include "grader/judge/tests/simulated.h"

namespace raylab::bench::simulated_bench {

constexpr int size = 48; // pixels a side

struct Habits {
    double start_up = 1, seconds_per_spp = 0.1;
    float scale = 1;      // of the image: 1 is right
    double exponent = -1; // of its error over samples
};

inline Contestant contestant(const std::string& name, Habits habits) {
    return {name, name + "'s title", [habits](int spp, std::uint32_t seed) {
                Drawn drawn;
                // Noise that falls as spp^exponent is that of spp^-exponent samples.
                const double worth = std::pow(spp, -habits.exponent);
                drawn.image = raylab::simulated::render(
                    size, size, seed, static_cast<int>(worth + 0.5),
                    raylab::simulated::Noise::pixel, [&](int, int) { return habits.scale; });
                drawn.seconds = habits.start_up + spp * habits.seconds_per_spp;
                return drawn;
            }};
}

inline std::vector<Row> rows_of(const std::vector<Contestant>& contestants,
                                const std::string& baseline, const Image* reference = nullptr) {
    EvaluateOptions options;
    options.plan.spp = {16, 64};
    options.baseline = baseline;
    return evaluate(take_turns(contestants, options.plan), reference, options);
}

} // namespace raylab::bench::simulated_bench
