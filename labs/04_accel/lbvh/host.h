// Boxes along the Morton curve, for files without device code.
#pragma once

#include "common/geometry/shapes.h"
#include "common/render/renderer.h"
#include "labs/04_accel/bvh/tree.h"

namespace raylab::lab04 {

// Copies the triangles to the device, builds there, and brings the tree back. seconds: of building
// alone, without the copies.
BvhTree build_lbvh(const std::vector<Triangle>& triangles, const MachineSettings& machine,
                   double& seconds);

} // namespace raylab::lab04
