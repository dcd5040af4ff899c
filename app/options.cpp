#include "app/options.h"

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

// An option that takes one of the names and stores what it stands for.
template <class T, class Target>
void add_choice(CLI::App& app, const std::string& name, Target& target,
                const std::map<std::string, T>& names, const std::string& help,
                const std::string& group) {
    app.add_option_function<std::string>(
           name, [&target, &names](const std::string& text) { target = names.at(text); }, help)
        ->check(CLI::IsMember(names))
        ->group(group);
}

} // namespace

void add_scene_options(CLI::App& app, SceneChanges& changes) {
    const std::string group = "Scene (instead of what the file says)";
    app.add_option("--spp", changes.spp, "samples a pixel")->group(group);
    app.add_option("--seed", changes.seed, "seed of the random numbers")->group(group);
    app.add_option("--depth", changes.depth, "surfaces a path may touch")->group(group);
    app.add_option("--width", changes.width, "film width in pixels")->group(group);
    app.add_option("--height", changes.height, "film height in pixels")->group(group);
    add_choice(app, "--integrator", changes.integrator, integrators, "how light is followed",
               group);
    add_choice(app, "--sampler", changes.sampler, samplers, "random numbers", group);
    add_choice(app, "--direct-light", changes.direct_light, strategies,
               "how light sources are found", group);
    app.add_option("--roulette", changes.roulette, "Russian roulette: true or false")->group(group);
}

void add_machine_options(CLI::App& app, MachineSettings& machine) {
    const std::string group = "Machine (none changes a bit of the image)";
    app.add_option("--threads", machine.threads, "host threads (default: one a core)")
        ->check(CLI::Range(0, 1024))
        ->group(group);
    app.add_option("--block", machine.block_size, "CUDA threads a block")
        ->check(CLI::Range(1, 1024))
        ->capture_default_str()
        ->group(group);
    add_choice(app, "--order", machine.order, orders, "order in which CUDA threads run", group);
    app.add_option("--order-seed", machine.order_seed, "seed of --order random")->group(group);
}

} // namespace raylab::app
