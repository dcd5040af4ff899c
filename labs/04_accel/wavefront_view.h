// What every stage is told of the wavefront. It lies in device memory, and kernels get its address.
#pragma once

#include "common/scene/view.h"
#include "labs/04_accel/pool.h"
#include "labs/04_accel/shapes/tree.h"
#include "labs/04_accel/structure.h"

namespace raylab::lab04 {

struct WavefrontView {
    SceneView scene; // without the groups that `shapes` holds: those are walked, not tested all
    RenderSettings settings;
    std::uint32_t sample; // index of the sample that this iteration adds to every pixel
    PoolView pool;
    StructureView structure; // over the scene's triangles
    ShapeTreeView shapes;    // over its spheres and quads
    WalkReport walked;
    int* shadow_rays; // slots whose shadow ray is on its way
    int* shadow_rays_sent;
};

} // namespace raylab::lab04
