// raylab render LAB SCENE: an image and its ledger.
#include "app/commands.h"
#include "app/interrupted.h"
#include "app/kept_render.h"
#include "app/memory_check.h"
#include "app/options.h"
#include "app/output.h"
#include "common/cli/files.h"
#include "common/cli/interrupt.h"
#include "common/cli/progress.h"
#include "common/image/image_file.h"
#include "grader/report/lanes.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <optional>

namespace raylab::app {

namespace {

constexpr std::uint64_t announced_bytes = 1 << 30; // a smaller need is not printed

struct RenderOptions {
    std::string lab, scene, output, stats, lanes;
    SceneChanges changes;
    MachineSettings machine;
    std::vector<int> snapshots;
    bool json = false, quiet = false;
};

// out.exr, 20 -> out_0020.exr
std::filesystem::path snapshot_path(const std::filesystem::path& output, int samples) {
    std::filesystem::path path = output;
    path.replace_filename(
        fmt::format("{}_{:04}{}", output.stem().string(), samples, output.extension().string()));
    return path;
}

void print_summary(const Ledger& ledger, const std::string& output) {
    fmt::print("{} {}: {} x {}, {} spp in {}, {}rays/s\n", ledger.lab, ledger.scene, ledger.width,
               ledger.height, ledger.samples, human_duration(ledger.seconds),
               human_count(static_cast<double>(ledger.rays()) / ledger.seconds));
    fmt::print("{}", to_table(ledger));
    if (ledger.rejected > 0)
        fmt::print("{} samples were not finite and were left out: this is a bug in the lab\n",
                   ledger.rejected);
    fmt::print("wrote {}\n", output);
}

// The 32 pixels of the warp in the middle of the image, as lab 02 deals pixels to threads.
struct MiddleWarp {
    static constexpr int lanes_of_warp = 32;
    int first_pixel;
    std::vector<PathRecord> paths; // of the latest sample

    explicit MiddleWarp(const Camera& camera)
        : first_pixel((camera.height / 2 * camera.width + camera.width / 2) / lanes_of_warp *
                      lanes_of_warp) {}
    void take(const Renderer& renderer) {
        const std::vector<PathRecord> all = renderer.records();
        const std::size_t end = std::min(all.size(), std::size_t(first_pixel) + lanes_of_warp);
        paths.assign(all.begin() + first_pixel, all.begin() + std::ptrdiff_t(end));
    }
};

// Writes the image and the ledger, and prints a summary.
void write_render(const RenderOptions& options, const Render& render, const MiddleWarp& warp,
                  const std::string& output) {
    write_image(render.image, output);
    if (!options.lanes.empty())
        write_file(options.lanes, lanes_picture(render.ledger, warp.paths, warp.first_pixel));
    if (!options.stats.empty()) write_file(options.stats, to_json(render.ledger) + "\n");
    if (options.json)
        fmt::print("{}\n", to_json(render.ledger));
    else if (!options.quiet)
        print_summary(render.ledger, output);
}

ExitCode run_render(const RenderOptions& options) {
    const Lab& lab = find_lab(options.lab);
    check_lab_options(lab, options.machine);
    const Scene scene = load_changed_scene(options.scene, options.changes);
    const std::string output = options.output.empty()
                                   ? fmt::format("out/{}_{}.exr", scene.name, lab.number)
                                   : options.output;
    const MemoryNeed need = memory_need(lab, scene, options.machine);
    const AvailableMemory available = available_memory();
    check_memory(need, available);
    if (!options.quiet && need.total() >= announced_bytes)
        fmt::print(stderr, "{} {}: {}\n", lab.number, scene.name, to_sentence(need, available));
    // A wrong file name is found now, and not after the render.
    prepare_image_output(output);
    if (!options.stats.empty()) prepare_output(options.stats);
    if (!options.lanes.empty()) prepare_output(options.lanes);
    for (const int done : options.snapshots) prepare_image_output(snapshot_path(output, done));
    for (const std::string& warning : scene.warnings)
        if (!options.quiet) fmt::print(stderr, "warning: {}\n", warning);

    const int spp =
        std::max(scene.render.spp, options.snapshots.empty() ? 0 : options.snapshots.back());
    const double pixels = static_cast<double>(scene.camera.width) * scene.camera.height;
    std::optional<Progress> progress;
    if (!options.quiet)
        progress.emplace(fmt::format("{} {}", lab.number, scene.name), spp, "samples", pixels);
    MiddleWarp warp(scene.camera);
    const auto after_sample = [&](const Renderer& renderer, int done) {
        if (progress) progress->update(done);
        if (!options.lanes.empty()) warp.take(renderer);
        if (std::binary_search(options.snapshots.begin(), options.snapshots.end(), done))
            write_image(develop(renderer, scene).image, snapshot_path(output, done));
    };
    const auto tick = [&] {
        if (progress) progress->tick();
    };
    const KeepsWork keeping;
    const Render render = render_and_keep(lab, scene, options.machine, spp, after_sample, tick);
    if (progress) progress->clear();
    const int samples = render.ledger.samples;
    if (!interrupted()) {
        write_render(options, render, warp, output);
        return ExitCode::success;
    }
    end_interrupted([&] {
        if (samples == 0)
            return say_interrupted(" before the first sample was finished: nothing was written");
        write_render(options, render, warp, output);
        say_interrupted(fmt::format(": '{}' has {} of {} samples a pixel", output, samples, spp));
    });
}

} // namespace

Run add_render(CLI::App& app) {
    auto options = std::make_shared<RenderOptions>();
    app.description("Render a scene with a lab: an image and its ledger.");
    app.add_option("LAB", options->lab, "01, 02, 03, 04 or the lab's folder name")->required();
    app.add_option("SCENE", options->scene, "a bundled scene's name, or a scene file")->required();
    app.add_option("-o,--output", options->output,
                   "image file: .exr, .pfm, .hdr or .png (default out/SCENE_LAB.exr)");
    app.add_option("--stats", options->stats, "write the ledger as JSON to this file");
    app.add_option("--lanes", options->lanes,
                   "draw where a warp's cycles are wasted, bounce by bounce, as this SVG file");
    app.add_option("--snapshots", options->snapshots, "also save the image after these iterations")
        ->delimiter(',')
        ->check(CLI::PositiveNumber);
    app.add_flag("--json", options->json, "print the ledger as JSON");
    app.add_flag("-q,--quiet", options->quiet, "print nothing but errors");
    add_scene_options(app, options->changes);
    add_machine_options(app, options->machine);
    add_wavefront_options(app, options->machine.wavefront);
    add_accel_options(app, options->machine.accel);
    app.footer(
        "Ctrl-C (SIGINT, SIGTERM, SIGHUP) ends a render early: the image is written with the "
        "samples that\nit has, with exit code 128 + signal. A second Ctrl-C ends at once and "
        "keeps nothing.\n"
        "Examples:\n"
        "  raylab render 02 cornell -o cornell.png\n"
        "  raylab render 02 cornell --spp 250 --snapshots 1,20,250 -o cornell.png\n"
        "  raylab render 02 cornell --lanes out/lanes.svg\n"
        "  raylab render 03 cornell --compact off --pool 4096\n"
        "  raylab render 04 stadium --accel kd --walk ropes\n"
        "  raylab render 01 scenes/whitted.json --threads 1 --stats ledger.json");
    return [options] {
        options->machine.records = !options->lanes.empty();
        std::sort(options->snapshots.begin(), options->snapshots.end());
        return run_render(*options);
    };
}

} // namespace raylab::app
