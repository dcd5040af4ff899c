// A polygon with any number of corners, cut into triangles.
#pragma once

#include "common/math/vec.h"

#include <array>
#include <vector>

namespace raylab {

// The triangles of a polygon of n >= 3 corners, n - 2 of them, as indices into `corners`, turning
// as the polygon turns. A simple polygon, convex or not, is covered once; of one that crosses
// itself or has no area the triangles are some. Quads are cut along the shorter diagonal that lies
// inside. Time grows with n times the number of corners that are not convex, and is bounded.
std::vector<std::array<int, 3>> cut_polygon(const std::vector<DVec3>& corners);

} // namespace raylab
