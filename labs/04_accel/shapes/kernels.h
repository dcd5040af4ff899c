// The kernels that walk through the tree over spheres and quads, one thread a ray.
#pragma once

#include "labs/04_accel/walks.h"

namespace raylab::lab04 {

// For the closest hit of each ray and for whether any is in the way of each shadow ray: the pool
// has what the triangles' walk has found, and is left with the closer one.
WalkKernels shape_kernels();

} // namespace raylab::lab04
