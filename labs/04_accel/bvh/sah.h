// Boxes by the surface area heuristic.
#pragma once

#include "common/geometry/shapes.h"
#include "labs/04_accel/bvh/tree.h"

namespace raylab::lab04 {

// No leaf lies deeper. Where the heuristic might lead deeper, nodes are cut into halves of the same
// number, so that the wide tree (wide/plan.h), three binary levels in one, fits into its levels.
constexpr int max_sah_depth = 48;

// A tree over the triangles that can be hit: one with a NaN or an infinity among its corners is
// left out. The same tree on every machine, whatever the number of threads; 0: one per core.
BvhTree build_bvh_sah(const std::vector<Triangle>& triangles, int threads = 1);

} // namespace raylab::lab04
