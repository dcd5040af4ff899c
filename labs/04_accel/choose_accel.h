// Which structure a scene gets, and how it is walked.
#pragma once

#include "labs/04_accel/walks.h"

#include <string>

namespace raylab::lab04 {

struct AccelChoice {
    KnownWalk walk;
    std::string why; // "asked for", "121 triangles are ..."
};

// Up to so many triangles, a ray tests all of them as fast as it goes down a tree. Measured ns a
// ray without a structure and with sah: 24 triangles 55 and 59, 48 triangles 94 and 74, 96
// triangles 166 and 103.
constexpr int few_triangles = 32;

// What is asked for; where it is left open, what is fastest. Throws SettingsError, which names the
// walks that there are, for a structure and a walk that do not go together.
AccelChoice choose_accel(int triangles, const AccelSettings& settings);

} // namespace raylab::lab04
