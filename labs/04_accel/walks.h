// Which structures there are, and which walks each of them has.
#pragma once

#include "common/render/accel_settings.h"
#include "labs/04_accel/kernels.h"

#include <vector>

namespace raylab::lab04 {

// The same walk for the closest hit and for any.
struct WalkKernels {
    StageKernel* closest;
    StageKernel* any;
};

struct KnownWalk {
    AccelKind accel;
    WalkKind walk; // automatic: brute force has but one
    WalkKernels kernels;
};

// The structures from the fastest to the slowest, and for each its walks, the fastest first.
const std::vector<KnownWalk>& known_walks();

} // namespace raylab::lab04
