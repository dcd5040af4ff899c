// What a block finds when it has moved a scene's shapes to its shared memory.
#pragma once

#include "common/scene/scene.h"

namespace raylab::lab03 {

// The arrays of shapes, in the order of SceneView.
constexpr int shape_arrays = 7;
constexpr const char* shape_array_names[shape_arrays] = {
    "spheres", "sphere_groups", "quads", "quad_groups", "planes", "triangles", "runs"};

// 1 for each array that lies in shared memory, and whose bytes are the scene's.
struct SharedShapes {
    int inside[shape_arrays], same[shape_arrays];
};

// The scene has at least 3 spheres, a quad, a plane and a triangle, and fits into 8 KiB.
SharedShapes look_at_shared_shapes(const Scene& scene, int block);

} // namespace raylab::lab03
