// raylab reference: the images that others are judged against, each with its own standard error.
#include "app/commands.h"
#include "app/interrupted.h"
#include "app/labs.h"
#include "app/output.h"
#include "common/cli/interrupt.h"
#include "common/cli/progress.h"
#include "common/image/image_file.h"
#include "common/image/mean.h"
#include "common/load/load.h"
#include "common/render/render.h"

#include <fmt/format.h>

#include <mutex>

namespace raylab::app {

namespace {

struct ReferenceOptions {
    std::vector<std::string> scenes;
    std::string lab = "02", folder = "scenes/references";
    int spp = 0, replicates = 32;
    std::uint32_t seed = 0x5eed0000;
    MachineSettings machine;
};

// The replicates that are finished so far.
struct Finished {
    std::mutex mutex;
    ImageMean mean;
};

void write_reference(const Image& image, const std::string& path, double seconds) {
    write_image(image, path);
    double error = 0, level = 0;
    for (std::size_t i = 0; i < image.pixels(); ++i) {
        error += image.variance(i).y;
        level += image.mean[i].y;
    }
    const double pixels = static_cast<double>(image.pixels());
    fmt::print("{}: {} spp, mean {:.5g}, standard error of a pixel {:.2g} (rms, green), {}\n", path,
               image.provenance.spp, level / pixels, std::sqrt(error / pixels),
               human_duration(seconds));
}

// Samples a pixel of the reference of that scene under this name; 0: there is none.
int spp_of(const std::string& path, const Scene& scene) try {
    const Provenance there = read_image(path).provenance;
    return there.scene_hash == scene.hash ? there.spp : 0;
} catch (const ImageError&) {
    return 0;
}

// 16 times the scene's own samples, in replicates with seeds of their own.
void make_reference(const ReferenceOptions& options, const std::string& name) {
    const Lab& lab = find_lab(options.lab);
    const Scene scene = load_scene(find_scene(name));
    const int total = options.spp > 0 ? options.spp : 16 * scene.render.spp;
    const int spp = std::max(1, total / options.replicates);
    const std::string path = fmt::format("{}/{}.exr", options.folder, scene.name);
    prepare_image_output(path);

    Finished finished;
    Progress progress(scene.name, options.replicates, "samples",
                      double(spp) * scene.camera.width * scene.camera.height);
    const auto work = [&] {
        const std::unique_ptr<Renderer> renderer = lab.make(scene, options.machine);
        for (int r = 0; r < options.replicates && !interrupted(); ++r) {
            const std::uint32_t seed = options.seed + static_cast<std::uint32_t>(r);
            const Image image = render(*renderer, scene, scene.camera, seed, spp).image;
            const std::lock_guard lock(finished.mutex);
            finished.mean.add(image);
            progress.update(finished.mean.count());
        }
    };
    const KeepsWork keeping;
    run_interruptibly(work, [&] { progress.tick(); });
    const std::lock_guard lock(finished.mutex);
    progress.clear();
    if (!interrupted()) return write_reference(finished.mean.mean(), path, progress.seconds());
    end_interrupted([&] {
        if (finished.mean.count() < 2)
            return say_interrupted(
                fmt::format(": '{}' was not written, since a variance takes two replicates", path));
        const Image image = finished.mean.mean();
        if (const int there = spp_of(path, scene); there > image.provenance.spp)
            return say_interrupted(fmt::format(": '{}' stays as it was, with {} spp where {} were "
                                               "finished",
                                               path, there, image.provenance.spp));
        write_reference(image, path, progress.seconds());
        say_interrupted(fmt::format(": '{}' has {} of {} replicates", path, finished.mean.count(),
                                    options.replicates));
    });
}

} // namespace

Run add_reference(CLI::App& app) {
    auto options = std::make_shared<ReferenceOptions>();
    app.description("Render reference images: many samples, variance per pixel from replicates, "
                    "provenance inside.");
    app.add_option("SCENES", options->scenes, "scenes (default: all bundled)");
    app.add_option("--lab", options->lab, "the lab that renders")->capture_default_str();
    app.add_option("-o,--output", options->folder, "folder")->capture_default_str();
    app.add_option("--spp", options->spp, "samples a pixel in all (default: 16 times the scene's)")
        ->check(CLI::PositiveNumber);
    app.add_option("--replicates", options->replicates, "independent renders to share them")
        ->check(CLI::Range(2, 1024))
        ->capture_default_str();
    app.add_option("--seed", options->seed, "seed of the first replicate");
    add_machine_options(app, options->machine);
    app.footer("Ctrl-C keeps the replicates that are finished, if two are, unless they "
               "would replace a\nreference of more samples.\n"
               "Examples:\n  raylab reference cornell\n  raylab reference --spp 65536 whitted");
    return [options] {
        if (options->scenes.empty()) options->scenes = bundled_scenes();
        for (const std::string& scene : options->scenes) make_reference(*options, scene);
        return ExitCode::success;
    };
}

} // namespace raylab::app
