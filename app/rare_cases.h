// Measures the rare cases (grader/bench/rare_case.h): labs 02 and 03 on scenes where compaction
// gains nothing.
#pragma once

#include "app/labs.h"
#include "grader/bench/rare_case.h"

#include <functional>
#include <vector>

namespace raylab::app {

// Lab 02 and the two wavefronts take turns, `rounds` times, case by case. Calls `show` with each
// row as soon as it is measured. Throws UsageError in a tree without lab 03.
std::vector<bench::RareCaseRow>
measure_rare_cases(const MachineSettings& machine, int rounds,
                   const std::function<void(const bench::RareCaseRow&)>& show);

} // namespace raylab::app
