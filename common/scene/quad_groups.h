// Laying quads out side by side, for the glance of common/geometry/quad_group.h.
#pragma once

#include "common/geometry/quad_group.h"
#include "common/geometry/shapes.h"

#include <vector>

namespace raylab {

// Puts quads into groups of sixteen, in their order. Call it again after a change of a scene's
// quads.
std::vector<QuadGroup> group_quads(const std::vector<Quad>& quads);

} // namespace raylab
