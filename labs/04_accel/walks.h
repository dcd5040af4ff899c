// The table of walks as the host has it, with their kernels.
#pragma once

#include "labs/04_accel/kernels.h"
#include "labs/04_accel/trees.h"

#include <string>
#include <vector>

namespace raylab::lab04 {

// The same walk for the closest hit and for any.
struct WalkKernels {
    StageKernel* closest;
    StageKernel* any;
};

// A row of walk_table.h.
struct KnownWalk {
    std::string accel, walk; // their names, as in AccelSettings; brute force's walk is "auto"
    const char* title;
    const char* when_endless;
    Prepare prepare; // null: the bare tree will do
    WalkKernels kernels;
};

// In the order of the table.
const std::vector<KnownWalk>& known_walks();

} // namespace raylab::lab04
