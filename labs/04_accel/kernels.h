// The kernels that do not walk, as the host launches them.
#pragma once

#include "common/math/features.h"
#include "common/scene/settings.h"
#include "common/wavefront/results.h"
#include "labs/04_accel/walk_tallies.h"
#include "labs/04_accel/wavefront_view.h"

namespace raylab::lab04 {

// A kernel that does one stage's work for each of a list's n slots, one thread a slot.
using StageKernel = void(const WavefrontView* wave, const int* slots, int n);

// The stages that depend on the scene's features, in the variant for this scene.
struct StageKernels {
    StageKernel* intersect;
    StageKernel* shade;
    StageKernel* shadow;
    // Whitted's shadow rays to one of the lights; null for path tracing, which sends its own from
    // shade.
    void (*shadow_rays)(const WavefrontView* wave, const int* slots, int n, int light);
};

StageKernels choose_kernels(Features features, Integrator integrator);

// Fills slots 0 ... n - 1, and the list, with the paths of the pixels first ... first + n - 1.
__global__ void generate_kernel(const WavefrontView* wave, int first, int n, int* live);

// Adds up what n walks visited.
__global__ void add_counts_kernel(const WalkCounts* counts, int n, WalkTally* tally);
inline constexpr int counts_per_thread = 64;

__global__ void accumulate_kernel(const WavefrontView* wave, int n, Results results);

} // namespace raylab::lab04
