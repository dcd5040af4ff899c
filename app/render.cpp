// raylab render LAB SCENE: an image and its ledger.
#include "app/commands.h"
#include "app/options.h"
#include "app/output.h"
#include "common/cli/files.h"
#include "common/cli/progress.h"
#include "common/image/image_file.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace raylab::app {

namespace {

struct RenderOptions {
    std::string lab, scene, output, stats;
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

ExitCode run_render(const RenderOptions& options) {
    const Lab& lab = find_lab(options.lab);
    check_lab_options(lab, options.machine);
    const Scene scene = load_changed_scene(options.scene, options.changes);
    const std::string output = options.output.empty()
                                   ? fmt::format("out/{}_{}.exr", scene.name, lab.number)
                                   : options.output;
    // What would fail at the end fails now, before the work.
    prepare_image_output(output);
    if (!options.stats.empty()) prepare_output(options.stats);
    for (const std::string& warning : scene.warnings)
        if (!options.quiet) fmt::print(stderr, "warning: {}\n", warning);

    const std::unique_ptr<Renderer> renderer = lab.make(scene, options.machine);
    const int spp =
        std::max(scene.render.spp, options.snapshots.empty() ? 0 : options.snapshots.back());
    {
        const double pixels = static_cast<double>(scene.camera.width) * scene.camera.height;
        Progress progress(fmt::format("{} {}", lab.number, scene.name), spp, "samples", pixels);
        for (int done = 1; done <= spp; ++done) {
            renderer->add_iteration();
            progress.update(done);
            if (std::binary_search(options.snapshots.begin(), options.snapshots.end(), done))
                write_image(develop(*renderer, scene), snapshot_path(output, done));
        }
    }
    write_image(develop(*renderer, scene), output);
    const Ledger ledger = renderer->ledger();
    if (!options.stats.empty()) write_file(options.stats, to_json(ledger) + "\n");
    if (options.json)
        fmt::print("{}\n", to_json(ledger));
    else if (!options.quiet)
        print_summary(ledger, output);
    return ExitCode::success;
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
    app.add_option("--snapshots", options->snapshots, "also save the image after these iterations")
        ->delimiter(',')
        ->check(CLI::PositiveNumber);
    app.add_flag("--json", options->json, "print the ledger as JSON");
    app.add_flag("-q,--quiet", options->quiet, "print nothing but errors");
    add_scene_options(app, options->changes);
    add_machine_options(app, options->machine);
    add_wavefront_options(app, options->machine.wavefront);
    add_accel_options(app, options->machine.accel);
    app.footer("Examples:\n"
               "  raylab render 02 cornell -o cornell.png\n"
               "  raylab render 02 cornell --spp 250 --snapshots 1,20,250 -o cornell.png\n"
               "  raylab render 03 cornell --compact off --pool 4096\n"
               "  raylab render 04 stadium --accel kd --walk ropes\n"
               "  raylab render 01 scenes/whitted.json --threads 1 --stats ledger.json");
    return [options] {
        std::sort(options->snapshots.begin(), options->snapshots.end());
        return run_render(*options);
    };
}

} // namespace raylab::app
