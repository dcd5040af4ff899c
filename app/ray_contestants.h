// The contestants of `raylab bench-rays`: the only place that names structures of labs and of peers
// together.
#pragma once

#include "grader/bench/rays/ray_contestant.h"

#include <string>
#include <vector>

namespace raylab::app {

// In the order in which they are shown.
std::vector<std::string> ray_contestant_names();

// The contestant of this name. Throws ContestantError if this build does not have it.
bench::RayContestant ray_contestant(const std::string& name);

} // namespace raylab::app
