// A walk that never ends for rays towards +x, and for the others is done at once.
#pragma once

#include "labs/04_accel/walks.h"

namespace raylab::lab04 {

WalkKernels planted_walk();

} // namespace raylab::lab04
