// Laying quads out side by side, for the glance of common/geometry/quad_group.h.
#pragma once

#include "common/geometry/quad_group.h"
#include "common/geometry/shapes.h"

#include <vector>

namespace raylab {

// Quads in their order, sixteen a group. Whoever changes a scene's quads calls this again.
std::vector<QuadGroup> group_quads(const std::vector<Quad>& quads);

} // namespace raylab
