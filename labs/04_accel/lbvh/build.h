// Boxes along the Morton curve, built on the device.
//
// Not the best tree, but the fastest one to build: by sorting, and by three kernels that build all
// nodes at the same time. It is for scenes that move and need a new tree for each frame.
#pragma once

#include "common/device/device_array.h"
#include "common/scene/view.h"
#include "labs/04_accel/bvh/tree.h"

namespace raylab::lab04 {

struct DeviceBvh {
    DeviceArray<BvhNode> nodes; // the root first; none: no triangle
    DeviceArray<TrianglePack> packs;
};

// triangles: in device memory. One with a NaN or an infinity among its corners is left out.
DeviceBvh build_lbvh(Array<Triangle> triangles);

// The same in host memory, for builders that go on from there, and for tests.
BvhTree to_host(const DeviceBvh& bvh);

} // namespace raylab::lab04
