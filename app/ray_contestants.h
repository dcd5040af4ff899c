// Who can take part in `raylab bench-rays`: the only place that brings structures of labs and peers
// to it.
#pragma once

#include "grader/bench/rays/ray_contestant.h"

#include <string>
#include <vector>

namespace raylab::app {

// In the order in which they are shown.
std::vector<std::string> ray_contestant_names();

// One of these names. Throws ContestantError if it is not here.
bench::RayContestant ray_contestant(const std::string& name);

} // namespace raylab::app
