// The barrier of a whole grid, for cooperative_groups (engine/cooperative.h).
#pragma once

#include "common/simt/site.h"

namespace raylab::simt {

// Waits for every thread of the launch, which must be cooperative.
void sync_grid(const Site& site);
bool in_cooperative_launch();

} // namespace raylab::simt
