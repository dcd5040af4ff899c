// Cutting a mesh into runs of neighbours.
#pragma once

#include "common/geometry/shapes.h"

#include <vector>

namespace raylab {

constexpr int triangles_per_run = 16;

// Sorts triangles[first..] so that neighbours in the array are neighbours in space, and appends
// their runs. Ids stay with their triangles. The order depends on the geometry and ids alone.
void cut_into_runs(std::vector<Triangle>& triangles, int first, std::vector<TriangleRun>& runs);

} // namespace raylab
