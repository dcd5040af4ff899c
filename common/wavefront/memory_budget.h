// How large a pool the memory allows.
//
// "Single biggest constraint is memory". Scene and film have fixed sizes; the pool takes what is
// left, because a smaller pool draws the same image in more fills. A pool below one warp is
// refused.
#pragma once

#include "common/render/renderer.h"

namespace raylab {

// In bytes of device memory.
struct MemoryNeeds {
    std::size_t scene_bytes = 0;     // all arrays of the scene
    std::size_t structure_bytes = 0; // over the scene's triangles, of labs that have one
    std::size_t film_bytes = 0;      // all that is kept for the pixels: film_bytes()
    std::size_t slot_bytes = 0;      // for each slot of the pool: path, branches, lists
};

// Room for Whitted's pending rays: one on each level that can split, which leaves out the last. 0
// for path tracing.
int branches_of(const RenderSettings& settings);

// The film's sums and, if they are kept, the paths' records. others: bytes a pixel of what a lab
// keeps beside these.
std::size_t film_bytes(const Scene& scene, bool records, std::size_t others = 0);

// Paths in flight that somebody wants: as many as the pool may have, and as there are pixels.
int wanted_paths(const Scene& scene, const WavefrontSettings& settings);

// Slots that fit into `budget` bytes, at most `wanted`. Throws SettingsError, with the figures,
// if there is not room for a warp.
int pool_that_fits(std::int64_t budget, const MemoryNeeds& needs, int wanted);

// The same for the budget of the settings or, without one, all that the device has.
int pool_on_device(const WavefrontSettings& settings, const MemoryNeeds& needs, int wanted);

// What the host is to know of: the film's part a pixel, the rest as a pool of `paths` takes it.
MemoryUse memory_use(const Scene& scene, const MemoryNeeds& needs, int paths);

} // namespace raylab
