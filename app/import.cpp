// raylab import FILE -o scene.json: a mesh file as a scene to edit.
#include "app/commands.h"
#include "app/import_scene.h"
#include "app/output.h"
#include "common/cli/files.h"
#include "common/load/load.h"
#include "common/load/read_file.h"

#include <fmt/format.h>

#include <filesystem>

namespace raylab::app {

namespace fs = std::filesystem;

namespace {

struct ImportOptions {
    std::string file, output;
    bool force = false, quiet = false;
};

ExitCode run_import(const ImportOptions& options) {
    const fs::path file = options.file, output = options.output;
    if (ending_of(output) != ".json")
        throw UsageError(
            fmt::format("'{}' is no name for a scene: it should end in .json", options.output));
    if (fs::exists(output) && !options.force)
        throw UsageError(fmt::format("'{}' is there already, perhaps edited: choose another name, "
                                     "or say --force to replace it",
                                     options.output));
    const auto read = [&](const std::string& name) {
        return read_file_or_throw(file.parent_path() / name);
    };
    const Mesh mesh = parse_mesh(read_file_or_throw(file), file.string(), read, MeshLook::own);
    prepare_output(options.output);
    const fs::path folder = fs::absolute(output).parent_path();
    const std::string name = fs::proximate(fs::absolute(file), folder).generic_string();
    const ImportedScene imported = import_scene(mesh, name, file.stem().string());
    const Scene scene = parse_scene(imported.text, output); // it must load as it stands
    write_file(options.output, imported.text);
    if (options.quiet) return ExitCode::success;
    fmt::print("wrote {}: {} triangles of {}; `raylab render 04 {}` renders it\n", options.output,
               scene.triangles.size(), name, options.output);
    for (const std::string& note : imported.notes) fmt::print("  - {}\n", note);
    return ExitCode::success;
}

} // namespace

Run add_import(CLI::App& app) {
    auto options = std::make_shared<ImportOptions>();
    app.description("Make a scene to edit of a glTF or OBJ file, as Blender and others export it: "
                    "camera, lights and materials written out, a line each.");
    app.add_option("FILE", options->file,
                   "a .glb, .gltf or .obj file; the scene keeps reading its "
                   "triangles and pictures from there")
        ->required();
    app.add_option("-o,--output", options->output, "the scene file to write, .json")->required();
    app.add_flag("--force", options->force, "replace a file that is there");
    app.add_flag("-q,--quiet", options->quiet, "print nothing but errors");
    app.footer(
        "What was chosen, approximated or left out is printed, a line each; docs/formats.md\n"
        "tells what of each format is read.\n"
        "Examples:\n"
        "  raylab import room.glb -o room.json && raylab render 04 room.json -o room.png\n"
        "  raylab import scenes/meshes/chess.glb -o /tmp/chess.json");
    return [options] { return run_import(*options); };
}

} // namespace raylab::app
