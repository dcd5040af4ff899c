// A polygon with any number of corners, cut into triangles.
#pragma once

#include "common/math/vec.h"

#include <array>
#include <vector>

namespace raylab {

// Cuts a polygon of n >= 3 corners into n - 2 triangles, which turn as the polygon turns. Returns
// indices into `corners`. The triangles cover a simple polygon once, convex or not. For a polygon
// that crosses itself or has no area they are any n - 2 triangles. Quads are cut along the shorter
// diagonal that lies inside. Time grows with n times the number of corners that are not convex, and
// is bounded.
std::vector<std::array<int, 3>> cut_polygon(const std::vector<DVec3>& corners);

} // namespace raylab
