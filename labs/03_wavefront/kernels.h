// The kernels, as the host launches them.
#pragma once

#include "common/scene/features.h"
#include "common/scene/settings.h"
#include "labs/03_wavefront/accumulate.h"
#include "labs/03_wavefront/wave.h"

namespace raylab::lab03 {

// A kernel that does one stage's work for each of a list's n slots, one thread a slot.
using StageKernel = void(const Wave* wave, const int* slots, int n);

// The stages that depend on the scene's features, in the variant for this scene.
struct StageKernels {
    StageKernel* intersect;
    StageKernel* shadow;
    StageKernel* shade;                      // any material
    StageKernel* shade_kind[material_kinds]; // one kind alone; null: the variant lacks it
};

// shared_geometry: intersect and shadow want geometry_bytes() of dynamic shared memory.
StageKernels choose_kernels(Features features, Integrator integrator, bool shared_geometry);

// Fills slots 0 ... n - 1 with the paths of pixels first ... first + n - 1, and the list with them.
__global__ void generate_kernel(const Wave* wave, int first, int n, std::uint32_t shuffle,
                                int* live);

__global__ void accumulate_kernel(const Wave* wave, int n, Results results);

} // namespace raylab::lab03
