// A whole bench, and what is written of it: bench.csv and bench.json for programs, a table for the
// terminal, and bench.html (page.h). The rare cases, if asked for, have a CSV of their own.
#pragma once

#include "grader/bench/against.h"
#include "grader/bench/evaluate.h"
#include "grader/bench/machine.h"
#include "grader/bench/rare_case.h"

#include <nlohmann/json.hpp>

namespace raylab::bench {

struct Bench {
    Machine machine;
    std::string command;
    EvaluateOptions options;
    int threads = 0; // of every contestant
    std::vector<SceneResult> scenes;
    std::vector<std::string> notes; // of the whole run
    std::optional<Comparison> against;
    std::vector<RareCaseRow> rare_cases; // empty unless asked for
};

// Figures that are not known become null.
nlohmann::ordered_json to_json(const Bench& bench);

// One line for each scene and contestant, a header first; RFC 4180. Unknown figures are empty.
std::string to_csv(const Bench& bench);

// For people.
std::string to_table(const SceneResult& scene);

// bench.csv, bench.json, bench.html and, if there are any, rare_cases.csv in `folder`. Throws
// FileError.
void write_bench(const Bench& bench, const std::string& folder);

} // namespace raylab::bench
