// Options that several commands share.
#include "app/options.h"

#include "common/scene/load.h"

#include <fmt/format.h>

#include <map>

namespace raylab::app {

namespace {

const std::map<std::string, Integrator> integrators = {{"path", Integrator::path},
                                                       {"whitted", Integrator::whitted}};
const std::map<std::string, SamplerKind> samplers = {{"sobol", SamplerKind::sobol},
                                                     {"independent", SamplerKind::independent}};
const std::map<std::string, DirectLight> strategies = {
    {"mis", DirectLight::mis}, {"light", DirectLight::light}, {"bsdf", DirectLight::bsdf}};
const std::map<std::string, ThreadOrder> orders = {{"forward", ThreadOrder::forward},
                                                   {"reverse", ThreadOrder::reverse},
                                                   {"random", ThreadOrder::random}};

template <class T> void change(T& value, const std::optional<T>& to) {
    if (to) value = *to;
}

} // namespace

void add_scene_options(CLI::App& app, SceneChanges& changes) {
    app.add_option("--spp", changes.spp, "samples a pixel")->group("Scene");
    app.add_option("--seed", changes.seed, "seed of the random numbers")->group("Scene");
    app.add_option("--depth", changes.depth, "surfaces a path may touch")->group("Scene");
    app.add_option("--width", changes.width, "film width in pixels")->group("Scene");
    app.add_option("--height", changes.height, "film height in pixels")->group("Scene");
    app.add_option("--integrator", changes.integrator, "path or whitted")
        ->check(CLI::IsMember(integrators))
        ->group("Scene");
    app.add_option("--sampler", changes.sampler, "sobol or independent")
        ->check(CLI::IsMember(samplers))
        ->group("Scene");
    app.add_option("--direct-light", changes.direct_light, "mis, light or bsdf")
        ->check(CLI::IsMember(strategies))
        ->group("Scene");
    app.add_option("--roulette", changes.roulette, "Russian roulette: true or false")->group("Scene");
}

void add_machine_options(CLI::App& app, MachineSettings& machine) {
    app.add_option("--threads", machine.threads, "host threads (default: one a core)")
        ->check(CLI::Range(0, 1024))
        ->group("Machine");
    app.add_option("--block", machine.block_size, "CUDA threads a block")
        ->check(CLI::Range(1, 1024))
        ->capture_default_str()
        ->group("Machine");
    app.add_option("--order", machine.order, "order of CUDA threads: forward, reverse or random")
        ->transform(CLI::CheckedTransformer(orders))
        ->group("Machine");
    app.add_option("--order-seed", machine.order_seed, "seed of --order random")->group("Machine");
}

Scene load_changed_scene(const std::string& name, const SceneChanges& changes) {
    Scene scene = load_scene(find_scene(name));
    RenderSettings& render = scene.render;
    change(render.spp, changes.spp);
    change(render.seed, changes.seed);
    change(render.max_depth, changes.depth);
    change(render.roulette, changes.roulette);
    if (changes.integrator) render.integrator = integrators.at(*changes.integrator);
    if (changes.sampler) render.sampler = samplers.at(*changes.sampler);
    if (changes.direct_light) render.direct_light = strategies.at(*changes.direct_light);
    const int width = changes.width.value_or(scene.camera.width);
    const int height = changes.height.value_or(scene.camera.height);
    if (const auto problem = problem_with(render, width, height))
        throw UsageError(fmt::format("{}: {}", problem->key, problem->what));
    set_film_size(scene.camera, width, height);
    return scene;
}

} // namespace raylab::app
