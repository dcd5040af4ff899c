// Changes to the objects `render` and `film` of a scene file, from a command line or a test.
#pragma once

#include "common/scene/scene.h"

#include <optional>
#include <string>

namespace raylab::app {

struct SceneChanges {
    std::optional<int> spp, depth, width, height;
    std::optional<std::uint32_t> seed;
    std::optional<Integrator> integrator;
    std::optional<SamplerKind> sampler;
    std::optional<DirectLight> direct_light;
    std::optional<bool> roulette, jitter;
};

// A film's size as a command line gives it, "512x384"; empty: no change. Throws UsageError.
SceneChanges film_size(const std::string& size);

// Loads a scene by name or path and applies the changes; the result is validated again. Throws
// SceneError if the scene is wrong, UsageError if a change is.
Scene load_changed_scene(const std::string& name, const SceneChanges& changes);

} // namespace raylab::app
