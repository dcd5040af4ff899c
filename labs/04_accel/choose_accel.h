// Which structure a scene gets, and how it is walked.
#pragma once

#include "labs/04_accel/walks.h"

#include <string>

namespace raylab::lab04 {

struct AccelChoice {
    KnownWalk walk;
    std::string why; // "asked for", "121 triangles are ..."
};

// Up to here testing them all was as fast (docs/measurements): a ray that goes down a tree waits
// for its nodes, one that tests all triangles waits for nothing.
constexpr int few_triangles = 32;

// What is asked for; where it is left open, what is fastest. Throws SettingsError, which names the
// walks that there are, for a structure and a walk that do not go together.
AccelChoice choose_accel(int triangles, const AccelSettings& settings);

} // namespace raylab::lab04
