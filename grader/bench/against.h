// This run against the bench.json of another commit: what changed, and what is noise.
//
// The two ran at different times on a machine that others may share, so seconds are not compared if
// it can be avoided. Both runs have ratios to the same baseline, and those are compared. A change
// of the baseline itself does not show in them; it does against a peer whose program stayed the
// same (--baseline cycles).
#pragma once

#include "grader/bench/statistics.h"

#include <nlohmann/json.hpp>

#include <stdexcept>
#include <string>

namespace raylab::bench {

struct Change {
    std::string scene, contestant;
    std::string quantity; // "speed" (samples a second) or "efficiency" (1 / (MSE seconds))
    std::string formed;   // "ratios to cycles" or "seconds of two runs"
    Ratio ratio;          // this run over the other; above 1 is better
    std::string verdict;  // "noise", "better" or "worse"
};

struct Comparison {
    std::string file, commit; // of the other run
    std::vector<Change> changes;
    std::vector<std::string> notes; // what could not be compared, and why
};

// what() is a sentence that names the file and the place in it.
struct AgainstError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// Throws AgainstError if the text is no bench.json.
nlohmann::json parse_bench(const std::string& text, const std::string& file);

// Both are a bench.json. Only scenes of the same hash, size and samples are compared.
Comparison compare_runs(const nlohmann::json& now, const nlohmann::json& other,
                        const std::string& file);

// For people; ends with how many changes chance alone would show.
std::string to_table(const Comparison& comparison);

} // namespace raylab::bench
