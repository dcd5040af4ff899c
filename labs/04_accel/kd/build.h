// Building a KD-tree over triangles.
#pragma once

#include "common/geometry/shapes.h"
#include "labs/04_accel/kd/split.h"
#include "labs/04_accel/kd/tree.h"

namespace raylab::lab04 {

struct KdBuildSettings {
    KdCosts costs = {};
    double copies = 6; // at most so many references a triangle
    int threads = 1;   // 0: one per core; the tree is the same from any number
};

// At most 8 + 1.3 log2 n cuts above a leaf, and never more than kd_max_depth.
int kd_depth_limit(std::size_t triangles);

// triangles: any. Those that no ray can hit, because they have no area or a NaN among their
// corners, are left out. Those that no plane parts share a leaf. The ropes are laid afterwards
// (kd/ropes.h).
KdTree build_kd_tree(const std::vector<Triangle>& triangles, const KdBuildSettings& settings = {});

} // namespace raylab::lab04
