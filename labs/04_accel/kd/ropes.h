// Ropes: from every face of a leaf a link to the node that lies behind the face. A walk that
// follows them needs no stack and never climbs. Popov et al. 2007, sections 3.2 and 4.1.
#pragma once

#include "labs/04_accel/kd/tree.h"

namespace raylab::lab04 {

// Fills in tree.leaf_of and tree.leaves.
void lay_ropes(KdTree& tree);

} // namespace raylab::lab04
