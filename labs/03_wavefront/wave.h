// What every stage is told. It lies in device memory, and kernels get its address.
#pragma once

#include "common/sampling/sampler.h"
#include "common/scene/view.h"
#include "labs/03_wavefront/first_bounce_cache.h"
#include "labs/03_wavefront/pool.h"
#include "labs/03_wavefront/queues.h"

namespace raylab::lab03 {

struct Wave {
    SceneView scene;
    RenderSettings settings;
    std::uint32_t sample; // index of the sample that this iteration adds to every pixel
    PoolView pool;
    Queues queues;
    FirstBounceCache first_bounce;
};

// Random numbers belong to a pixel and a sample. A slot's number, or a thread's, must not enter:
// they change with the pool's size, with compaction and with sorting.
HD Sampler sampler_of(const Wave& wave, int slot) {
    return {wave.settings.sampler, wave.settings.seed, wave.pool.pixel[slot], wave.sample};
}

} // namespace raylab::lab03
