// What a block finds when it has moved a scene's shapes to its shared memory.
#pragma once

#include "common/scene/scene.h"

namespace raylab::lab03 {

struct SharedShapes {
    int inside, same; // 1: all shapes lie in shared memory; they are the scene's
};

// The scene has at least 3 spheres, a quad, a plane and a triangle, and fits into 8 KiB.
SharedShapes look_at_shared_shapes(const Scene& scene, int block);

} // namespace raylab::lab03
