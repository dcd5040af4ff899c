// raylab debug LAB SCENE --pixel X,Y: gdb, stopped in the CUDA thread that works for one bounce of
// one path.
//
// The program starts itself again under gdb, with the same command line. The environment's
// RAYLAB_STOP tells the second start where to stop (common/sampling/path_stop.h).
#include "app/commands.h"
#include "app/gdb.h"
#include "common/sampling/path_stop.h"

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <iterator>

namespace raylab::app {

namespace {

constexpr char stop_variable[] = "RAYLAB_STOP";

struct DebugOptions {
    std::string lab, scene;
    std::vector<int> pixel; // x, y
    int sample = 0, bounce = camera_ray_stop;
    SceneChanges changes;
    MachineSettings machine;
};

void check_stop(const DebugOptions& options, const Scene& scene) {
#if !defined(RAYLAB_STOPS)
    throw UsageError(
        "this build of raylab cannot stop at a path: use ./raylab debug, or configure the "
        "preset 'debug'");
#endif
    const int x = options.pixel[0], y = options.pixel[1];
    if (x >= scene.camera.width || y >= scene.camera.height)
        throw UsageError(
            fmt::format("--pixel {},{}: the image of '{}' has {} x {} pixels, and (0,0) is "
                        "the top left one",
                        x, y, scene.name, scene.camera.width, scene.camera.height));
    if (options.bounce == camera_ray_stop) return;
    if (scene.render.integrator == Integrator::whitted)
        throw UsageError(
            fmt::format("--bounce: '{}' is rendered by Whitted's tracer, whose rays form a "
                        "tree; leave --bounce out to stop at the camera ray",
                        scene.name));
    if (options.bounce >= scene.render.max_depth)
        throw UsageError(fmt::format("--bounce {}: the paths of '{}' have bounces 0 to {}",
                                     options.bounce, scene.name, scene.render.max_depth - 1));
}

std::vector<std::string> own_command_line() {
    std::ifstream file("/proc/self/cmdline", std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    std::vector<std::string> arguments;
    for (std::size_t at = 0; at < text.size(); at += arguments.back().size() + 1)
        arguments.emplace_back(text.c_str() + at);
    if (arguments.empty()) throw std::runtime_error("cannot read /proc/self/cmdline");
    arguments.front() = RAYLAB_PROGRAM_FILE;
    return arguments;
}

void start_gdb(const DebugOptions& options, const Scene& scene) {
    const int pixel = options.pixel[1] * scene.camera.width + options.pixel[0];
    const std::string stop = fmt::format("{} {} {}", pixel, options.sample, options.bounce);
    setenv(stop_variable, stop.c_str(), 1);
    run_gdb(RAYLAB_ROOT, "raylab::path_stop", own_command_line());
}

ExitCode run_debug(DebugOptions options) {
    const Lab& lab = find_lab(options.lab);
    options.machine.threads = 1; // no other CUDA thread runs meanwhile
    check_lab_options(lab, options.machine);
    const Scene scene = load_changed_scene(options.scene, options.changes);
    check_stop(options, scene);
    if (std::getenv(stop_variable) == nullptr) {
        start_gdb(options, scene);
        return ExitCode::success;
    }

    const auto renderer = lab.make(scene, options.machine);
    for (int done = 0; done <= options.sample; ++done) renderer->add_iteration();
    fmt::print("{} {}: sample {} is done; nothing is written\n", lab.number, scene.name,
               options.sample);
    return ExitCode::success;
}

} // namespace

Run add_debug(CLI::App& app) {
    auto options = std::make_shared<DebugOptions>();
    app.description("Open gdb, stopped in the thread that works for one bounce of one path.");
    app.add_option("LAB", options->lab, "01, 02, 03, 04 or the lab's folder name")->required();
    app.add_option("SCENE", options->scene, "a bundled scene's name, or a scene file")->required();
    app.add_option("--pixel", options->pixel, "X,Y: the path's pixel; 0,0 is the top left one")
        ->delimiter(',')
        ->expected(2)
        ->check(CLI::NonNegativeNumber)
        ->required();
    app.add_option("--sample", options->sample, "the path's sample, from 0 on (default 0)")
        ->check(CLI::NonNegativeNumber);
    app.add_option(
           "--bounce", options->bounce,
           "stop where this bounce, from 0 on, takes its random numbers (default: where the "
           "camera ray does)")
        ->check(CLI::NonNegativeNumber);
    add_scene_options(app, options->changes);
    add_machine_options(app, options->machine);
    add_wavefront_options(app, options->machine.wavefront);
    add_accel_options(app, options->machine.accel);
    app.footer(
        "In gdb: `print $pixel()`, `print $threadIdx(\"x\")`, `next`, `print throughput`; "
        "app/gdb_kernels.py lists\nthe functions. The kernels run on one worker thread; gdb needs "
        "no GPU.\n"
        "Examples:\n"
        "  raylab debug 02 cornell --pixel 32,32 --width 64 --height 64\n"
        "  raylab debug 03 cornell --pixel 100,200 --sample 1 --bounce 3\n"
        "  raylab debug 04 stadium --pixel 10,20 --bounce 0 --accel kd --walk ropes");
    return [options] { return run_debug(*options); };
}

} // namespace raylab::app
