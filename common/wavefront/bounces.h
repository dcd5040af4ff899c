// How many bounces a wavefront may take, and how many of them the ledger tells apart.
#pragma once

#include "common/scene/settings.h"

namespace raylab {

// A path has a bounce for each surface, Whitted's tree one for each node.
inline int most_bounces(const RenderSettings& settings) {
    return settings.integrator == Integrator::whitted ? 1 << settings.max_depth
                                                      : settings.max_depth;
}

// Bounces of a tree beyond the 64th are counted as the 64th.
inline int counted_bounces(const RenderSettings& settings) {
    return settings.integrator == Integrator::whitted ? 64 : settings.max_depth;
}

} // namespace raylab
