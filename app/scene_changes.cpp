#include "app/scene_changes.h"

#include "app/labs.h"
#include "common/scene/load.h"

#include <fmt/format.h>

namespace raylab::app {

namespace {
template <class T> void change(T& value, const std::optional<T>& to) {
    if (to) value = *to;
}
} // namespace

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
