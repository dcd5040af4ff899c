#include "app/options.h"

#include <fmt/format.h>

#include <charconv>
#include <map>
#include <set>

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
const std::map<std::string, ScanKind> scans = {
    {"serial", ScanKind::serial},       {"naive", ScanKind::naive},
    {"efficient", ScanKind::efficient}, {"warp", ScanKind::warp},
    {"library", ScanKind::library},     {"lookback", ScanKind::lookback}};
const std::map<std::string, MaterialSort> sorts = {
    {"off", MaterialSort::off}, {"on", MaterialSort::on}, {"queues", MaterialSort::queues}};

// The names that the labs know for one member of AccelSettings, and "auto".
std::set<std::string> accel_names(std::string AccelSettings::*which) {
    std::set<std::string> names = {AccelSettings{}.*which};
    for (const Lab& lab : labs())
        if (lab.accels != nullptr)
            for (const AccelSettings& accel : lab.accels()) names.insert(accel.*which);
    return names;
}

// "off", "on" or a number of bounces; -1 if it is none of these.
int parse_compact(const std::string& text) {
    if (text == "off") return 0;
    if (text == "on") return 1;
    int every = -1;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, every);
    return error == std::errc() && stop == end && every >= 1 ? every : -1;
}

// Adds an option that takes one of the names and stores the value that belongs to it.
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
    app.add_option("--jitter", changes.jitter,
                   "camera rays through random points of their pixel: true or false")
        ->group(group);
}

void add_machine_options(CLI::App& app, MachineSettings& machine) {
    machine.records = false; // only `render --lanes` reads them
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

void add_wavefront_options(CLI::App& app, WavefrontSettings& wavefront) {
    const std::string group =
        "Pool of rays (lab 03; --pool, --memory-budget: also 04; none changes a bit)";
    app.add_option_function<std::string>(
           "--compact",
           [&wavefront](const std::string& text) { wavefront.compact_every = parse_compact(text); },
           "remove ended rays: off, on (after each bounce) or after every K-th bounce")
        ->check([](const std::string& text) {
            return parse_compact(text) < 0
                       ? fmt::format("'{}' is neither off, on nor a number of bounces, 1 or more",
                                     text)
                       : std::string();
        })
        ->type_name("off|on|K")
        ->group(group);
    add_choice(app, "--scan", wavefront.scan, scans, "prefix sums", group);
    add_choice(app, "--sort", wavefront.sort, sorts,
               "by material: not at all, one sorted list, or a queue and a kernel for each", group);
    app.add_option("--pool", wavefront.pool, "paths in flight, at most")
        ->check(CLI::Range(1, 1 << 28))
        ->capture_default_str()
        ->group(group);
    app.add_option("--shuffle", wavefront.shuffle, "seed that deals pixels out to slots")
        ->group(group);
    app.add_option_function<int>(
           "--memory-budget",
           [&wavefront](int mib) { wavefront.memory_budget = std::int64_t{mib} << 20; },
           "MiB of device memory for scene, film and pool (default: all there is)")
        ->check(CLI::Range(1, 1 << 20))
        ->type_name("MIB")
        ->group(group);
    app.add_flag("--shared-geometry", wavefront.shared_geometry,
                 "read shapes from shared memory, if they fit")
        ->group(group);
    app.add_flag("--first-bounce-cache", wavefront.first_bounce_cache,
                 "trace camera rays once, for all iterations")
        ->group(group);
    app.add_flag("--regenerate", wavefront.regenerate, "ended paths make room for new ones at once")
        ->group(group);
}

void add_accel_options(CLI::App& app, AccelSettings& accel) {
    const std::string group = "Structure over the triangles (lab 04; none changes a bit)";
    app.add_option(
           "--accel", accel.accel,
           "none (every triangle is tested), a KD-tree, boxes along the Morton curve, boxes "
           "by surface area, or eight boxes a node")
        ->check(CLI::IsMember(accel_names(&AccelSettings::accel)))
        ->group(group);
    app.add_option("--walk", accel.walk, "how a ray gets back from a subtree")
        ->check(CLI::IsMember(accel_names(&AccelSettings::walk)))
        ->group(group);
}

void check_lab_options(const Lab& lab, const MachineSettings& machine) {
    const WavefrontSettings& wavefront = machine.wavefront;
    const WavefrontSettings pool_alone = {.pool = wavefront.pool,
                                          .memory_budget = wavefront.memory_budget};
    if (!lab.has_pool && wavefront != WavefrontSettings{})
        throw UsageError(fmt::format(
            "lab {} has no pool of rays: --pool and --memory-budget are for labs 03 and 04, "
            "--compact, --scan, --sort, --shuffle, --shared-geometry, --first-bounce-cache and "
            "--regenerate for lab 03",
            lab.number));
    if (!lab.has_wavefront && wavefront != pool_alone)
        throw UsageError(
            fmt::format("lab {} runs its pool in one way: --compact, --scan, --sort, --shuffle, "
                        "--shared-geometry, --first-bounce-cache and --regenerate are for lab 03",
                        lab.number));
    if (lab.accels == nullptr && machine.accel != AccelSettings{})
        throw UsageError(fmt::format("lab {} has no structure over its triangles: --accel and "
                                     "--walk are for lab 04",
                                     lab.number));
}

} // namespace raylab::app
