// What every stage is told of the wavefront. It lies in device memory, and kernels get its address.
#pragma once

#include "common/scene/view.h"
#include "labs/03_wavefront/first_bounce_cache.h"
#include "labs/03_wavefront/pool.h"
#include "labs/03_wavefront/queues.h"

namespace raylab::lab03 {

struct WavefrontView {
    SceneView scene;
    RenderSettings settings;
    std::uint32_t sample; // index of the sample that this iteration adds to every pixel
    PoolView pool;
    Queues queues;
    FirstBounceCache first_bounce;
};

} // namespace raylab::lab03
