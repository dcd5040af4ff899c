// Lab 04's structures and walks for `raylab bench-rays`.
#pragma once

#include "grader/bench/rays/ray_contestant.h"

#include <vector>

namespace raylab::app {

// One for each structure and walk, "sah_skip"; none where this tree has no lab 04.
std::vector<bench::RayContestant> lab04_ray_contestants();

} // namespace raylab::app
