// raylab export SCENE --mitsuba|--blender: a scene for another renderer.
#include "app/commands.h"
#include "app/export_blender.h"
#include "app/export_mitsuba.h"
#include "common/cli/files.h"

#include <fmt/format.h>

namespace raylab::app {

namespace {

struct ExportOptions {
    std::string scene, folder;
    bool mitsuba = false, blender = false, quiet = false;
    SceneChanges changes;
};

ExitCode run_export(const ExportOptions& options) {
    if (options.mitsuba == options.blender)
        throw UsageError("export for whom? Say --mitsuba or --blender");
    const Scene scene = load_changed_scene(options.scene, options.changes);
    const std::string folder =
        options.folder.empty()
            ? fmt::format("out/{}_{}", scene.name, options.mitsuba ? "mitsuba" : "blender")
            : options.folder;
    std::vector<ExportedFile> files;
    try {
        files = options.mitsuba ? mitsuba_files(scene) : blender_files(scene);
    } catch (const UsageError& error) {
        throw UsageError(fmt::format("{} {}", scene.name, error.what()));
    }
    prepare_output(folder + "/" + files.back().name);
    for (const ExportedFile& file : files) write_file(folder + "/" + file.name, file.bytes);
    if (options.quiet) return ExitCode::success;
    if (options.blender)
        fmt::print("wrote {0}/scene.py; `blender -b --python {0}/scene.py -- -o image.exr` renders "
                   "it\n",
                   folder);
    else
        fmt::print("wrote {}/scene.xml and {} files beside it; `mitsuba {}/scene.xml` renders it\n",
                   folder, files.size() - 1, folder);
    return ExitCode::success;
}

} // namespace

Run add_export(CLI::App& app) {
    auto options = std::make_shared<ExportOptions>();
    app.description("Write a scene for an independent renderer, to compare with.");
    app.add_option("SCENE", options->scene, "a bundled scene's name, or a scene file")->required();
    app.add_flag("--mitsuba", options->mitsuba, "as a Mitsuba 3 scene");
    app.add_flag("--blender", options->blender, "as a Python file that Blender Cycles renders");
    app.add_option("-o,--output", options->folder,
                   "folder for scene.xml and what it names, or for scene.py "
                   "(default out/SCENE_mitsuba or out/SCENE_blender)");
    app.add_flag("-q,--quiet", options->quiet, "print nothing but errors");
    add_scene_options(app, options->changes);
    app.footer("Examples:\n"
               "  raylab export cornell --mitsuba -o /tmp/cornell\n"
               "  raylab export cornell_peers --blender --width 512 --height 512\n"
               "  raylab export whitted --mitsuba --integrator path --width 64 --height 48");
    return [options] { return run_export(*options); };
}

} // namespace raylab::app
