#include "app/scene_changes.h"

#include "app/labs.h"
#include "common/load/load.h"

#include <fmt/format.h>

#include <cstdio>

namespace raylab::app {

namespace {
template <class T> void change(T& value, const std::optional<T>& to) {
    if (to) value = *to;
}
} // namespace

SceneChanges film_size(const std::string& size) {
    SceneChanges changes;
    if (size.empty()) return changes;
    int width = 0, height = 0, end = 0;
    if (std::sscanf(size.c_str(), "%dx%d%n", &width, &height, &end) != 2 ||
        end != static_cast<int>(size.size()))
        throw UsageError(
            fmt::format("--size '{}': expected width x height in pixels, like 512x512", size));
    if (const auto problem = problem_with({}, width, height))
        throw UsageError(fmt::format("{}: {}", problem->key, problem->what));
    changes.width = width;
    changes.height = height;
    return changes;
}

Scene load_changed_scene(const std::string& name, const SceneChanges& changes) {
    Scene scene = load_scene(find_scene(name));
    RenderSettings& render = scene.render;
    change(render.spp, changes.spp);
    change(render.seed, changes.seed);
    change(render.max_depth, changes.depth);
    change(render.roulette, changes.roulette);
    change(render.jitter, changes.jitter);
    change(render.integrator, changes.integrator);
    change(render.sampler, changes.sampler);
    change(render.direct_light, changes.direct_light);
    const int width = changes.width.value_or(scene.camera.width);
    const int height = changes.height.value_or(scene.camera.height);
    if (const auto problem = problem_with(render, width, height))
        throw UsageError(fmt::format("{}: {}", problem->key, problem->what));
    set_film_size(scene.camera, width, height);
    return scene;
}

} // namespace raylab::app
