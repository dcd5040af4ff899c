// What every stage is told. It lies in device memory, and kernels get its address.
#pragma once

#include "common/sampling/sampler.h"
#include "common/scene/view.h"
#include "labs/04_accel/pool.h"
#include "labs/04_accel/shapes/tree.h"
#include "labs/04_accel/structure.h"

namespace raylab::lab04 {

struct Wave {
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

// Random numbers belong to a pixel and a sample, never to a slot or a thread.
HD Sampler sampler_of(const Wave& wave, int slot) {
    return {wave.settings.sampler, wave.settings.seed, wave.pool.pixel[slot], wave.sample};
}

} // namespace raylab::lab04
