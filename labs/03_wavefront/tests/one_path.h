// One path, stage by stage: what each stage of task 3.1 leaves in the path's slot.
#pragma once

#include "common/scene/scene.h"
#include "common/wavefront/path_pool.h"

#include <cstdint>
#include <vector>

namespace raylab::lab03 {

// How the path begins. Nothing that a stage writes may depend on the slot.
struct PathBegin {
    int slot = 2; // of four
    std::uint32_t sample = 0;
    int bounce = 0;          // as if so many surfaces lay behind it,
    float throughput = 0.5f; // and the product of their weights were this
};

// The path's slot after a stage. Vectors are in world coordinates.
struct PathState {
    bool hit; // the ray met a shape
    int kind; // 99 before the first intersection
    bool alive;
    PathRecord record;
    Vec3 radiance, throughput, origin, direction;
    int bounce;
    float bsdf_pdf;
    bool sends; // what the shading stage returned; false after the other stages
    Vec3 shadow_ray_light;
    // Whitted's tree: the number of its node, the branches that wait, and the newest of them.
    std::uint32_t node;
    int pending;
    PendingRay newest;
};

constexpr int path_states = 4; // after intersect, shade, intersect, shade; dead paths do nothing

// The path of the middle pixel of a 3 x 3 image of the scene, which has spheres, planes, a point
// light or a constant sky, and materials that are diffuse, mirrors or glass.
std::vector<PathState> follow_path(const Scene& scene, const PathBegin& begin = {});

// The pool and the list behind a generate kernel, both with more room than it has paths to start.
struct Started {
    std::vector<int> listed;          // by place; -1: nothing was written there
    std::vector<std::uint32_t> pixel; // by slot; unwritten_pixel: nothing was written there
};
constexpr std::uint32_t unwritten_pixel = 0xffffffff;

// Starts n paths for the pixels from `first` on, dealt out by this shuffle, in blocks of 32
// threads.
Started start_paths(const Scene& scene, int first, int n, std::uint32_t shuffle);

} // namespace raylab::lab03
