// The kernels, as the host launches them.
#pragma once

#include "common/math/features.h"
#include "common/scene/settings.h"
#include "common/wavefront/results.h"
#include "labs/03_wavefront/wavefront_view.h"

namespace raylab::lab03 {

// A kernel that does one stage's work for each of a list's n slots, one thread a slot.
using StageKernel = void(const WavefrontView* wave, const int* slots, int n);

// The stages that depend on the scene's features, in the variant for this scene.
struct StageKernels {
    StageKernel* intersect;
    StageKernel* shadow;
    StageKernel* shade;                      // any material
    StageKernel* shade_kind[material_kinds]; // one kind alone; null: the variant lacks it
};

// shared_geometry: intersect and shadow want geometry_bytes() of dynamic shared memory.
StageKernels choose_kernels(Features features, Integrator integrator, bool shared_geometry);

// Fills slots 0 ... n - 1, and the list, with the paths of n of the pixels first ... first +
// dealt - 1, which are dealt out in the order that the seed `shuffle` says.
__global__ void generate_kernel(const WavefrontView* wave, int first, int n, int dealt,
                                std::uint32_t shuffle, int* live);

__global__ void accumulate_kernel(const WavefrontView* wave, int n, Results results);

// Accumulates the paths of the list that have ended, and starts those of the pixels from *next on
// in their slots, as long as there are pixels.
__global__ void regenerate_kernel(const WavefrontView* wave, const int* live, int n, int* next,
                                  int pixels, std::uint32_t shuffle, Results results);

} // namespace raylab::lab03
