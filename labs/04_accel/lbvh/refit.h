// The boxes of a hierarchy, from the leaves up (Karras 2012, section 4).
#pragma once

#include "common/simt/cuda.h"
#include "labs/04_accel/bvh/bvh.h"
#include "labs/04_accel/leaf/triangle_pack.h"

namespace raylab::lab04 {

// One thread for each leaf, which goes up from there. At each node two threads arrive, one from
// each child. The first one ends there. The second one knows that both boxes are written, and goes
// on. arrived: 0 for each node before.
__global__ void refit_kernel(const TrianglePack* packs, int leaves, const int* leaf_parents,
                             BvhNode* nodes, int* arrived);

// A tree of one leaf: a root with nothing on its other side.
__global__ void lone_leaf_kernel(const TrianglePack* packs, BvhNode* nodes);

} // namespace raylab::lab04
