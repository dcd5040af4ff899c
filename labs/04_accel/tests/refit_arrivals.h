// Task 4.6 alone, on a tree whose nodes and leaves are known.
#pragma once

#include "labs/04_accel/bvh/tree.h"

#include <vector>

namespace raylab::lab04 {

// How many threads came to each node when its boxes were found. leaf_parents: of each pack.
std::vector<int> refit_arrivals(const BvhTree& tree, const std::vector<int>& leaf_parents);

} // namespace raylab::lab04
