// Other renderers as contestants: the scene is exported for them, and each render is a process of
// its own, so that its start-up is whole and shows as the time at 0 samples.
#pragma once

#include "common/scene/scene.h"
#include "grader/bench/contestant.h"

namespace raylab::app {

struct PeerSettings {
    std::string python = "python3", blender = "blender"; // programs
    std::string folder;                                  // for exported scenes and images
    int threads = 0;                                     // for each render
    double limit = 600;                                  // seconds for one render
};

// The names that peer_contestant() knows.
const std::vector<std::string>& peer_names(); // cycles, mitsuba_llvm, mitsuba_scalar

// Exports the scene and asks the program for its version. Throws ContestantError with one sentence
// if the peer is absent or cannot draw the scene.
bench::Contestant peer_contestant(const std::string& name, const Scene& scene,
                                  const PeerSettings& settings);

} // namespace raylab::app
