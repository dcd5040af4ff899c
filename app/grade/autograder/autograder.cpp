// raylab autograder LAB --for PLATFORM -o DIR: what a platform needs to grade the lab by itself.
#include "app/grade/autograder/package.h"
#include "app/grade/commands.h"

#include <fmt/format.h>

namespace raylab::app {

namespace {

struct AutograderOptions {
    std::string lab, platform, folder;
};

ExitCode run_autograder(const GraderTree& tree, const AutograderOptions& options) {
    const Platform& platform = platform_of(options.platform);
    const LabSheet sheet = find_lab(tree.root, options.lab);
    write_package(platform, sheet, options.folder);
    fmt::print("{}: lab {} for {}; README.md there says how to upload it\n", options.folder,
               sheet.number, platform.title);
    if (platform.grades())
        fmt::print("It contains the solutions and a key: keep it where no student can read it.\n");
    return ExitCode::success;
}

} // namespace

Run add_autograder(CLI::App& app, const GraderTree& tree) {
    auto options = std::make_shared<AutograderOptions>();
    app.description("Make the package with which a platform grades a lab, ready to upload.");
    app.add_option("LAB", options->lab, "lab: 01, 02, ... or its folder's name")->required();
    app.add_option("--for", options->platform, "gradescope, prairielearn or classroom50")
        ->required();
    app.add_option("-o,--output", options->folder,
                   "folder for the package; not there yet, or empty")
        ->required();
    app.footer(
        "Examples:\n  raylab autograder 02 --for gradescope -o out/gradescope02\n"
        "  raylab autograder 02 --for prairielearn -o out/prairielearn02\n"
        "README.md in the package says how to upload it and what sandbox to expect. Packages "
        "for\nGradescope and PrairieLearn contain the solutions and the key of the hidden "
        "scenes.");
    return [options, tree] { return run_autograder(tree, *options); };
}

} // namespace raylab::app
