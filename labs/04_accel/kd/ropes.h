// Ropes: from every face of a leaf to what lies behind it, so that a walk needs neither a stack nor
// the way back up. Popov et al. 2007, sections 3.2 and 4.1.
#pragma once

#include "labs/04_accel/kd/tree.h"

namespace raylab::lab04 {

// Fills in tree.leaf_of and tree.leaves.
void lay_ropes(KdTree& tree);

} // namespace raylab::lab04
