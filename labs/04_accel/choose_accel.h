// Which structure a scene gets, and how it is walked.
#pragma once

#include "labs/04_accel/walks.h"

#include <string>

namespace raylab::lab04 {

struct AccelChoice {
    KnownWalk walk;
    std::string why; // "asked for", "121 triangles are ..."
};

// Up to here a ray tests all triangles as fast as it finds its way down a tree. Measured, ns a ray
// of none and of sah: 24 triangles 55 and 59, 48 triangles 94 and 74, 96 triangles 166 and 103.
constexpr int few_triangles = 32;

// What is asked for; where it is left open, what is fastest. Throws SettingsError, which names the
// walks that there are, for a structure and a walk that do not go together.
AccelChoice choose_accel(int triangles, const AccelSettings& settings);

} // namespace raylab::lab04
