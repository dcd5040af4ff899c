// Closest hits alone: raylab's test of every triangle against Intel's Embree, one thread, the same
// rays. What lab 04's trees will be measured with; here it says how far brute force is from the
// art.
//
// Embree (I. Wald et al., "Embree: A Kernel Framework for Efficient CPU Ray Tracing", SIGGRAPH
// 2014) takes part if it was there when raylab was built. Without it every call throws
// ContestantError.
#pragma once

#include "common/scene/scene.h"
#include "grader/bench/contestant.h"
#include "grader/bench/statistics.h"

#include <optional>
#include <vector>

namespace raylab::bench {

struct TraversalRow {
    std::string rays;                    // "camera" or "bounce"
    int count = 0;                       // of rays
    Measured raylab_mrays, embree_mrays; // million rays a second
    int differing = 0;                   // rays with another answer, or t off by more than 1e-4
    std::optional<Measured> ratio;       // raylab over Embree; only if at most 1e-4 of rays differ
};

struct TraversalResult {
    std::string scene, left_out; // "2 spheres": Embree is asked about polygons alone
    int triangles = 0;           // for Embree; a quad counts as two
    std::vector<TraversalRow> rows;
};

// "Embree 3.13.5", or empty without it.
std::string embree_version();

// One ray through each pixel of a film of at most 128 x 128, and from what they hit
// one ray in a cosine-distributed direction. Throws ContestantError if the scene has no polygons.
TraversalResult bench_traversal(const Scene& scene, int rounds);

} // namespace raylab::bench
