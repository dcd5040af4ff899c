#include "app/course/proof_build.h"

#include "common/cli/process.h"

#include <fmt/format.h>

namespace raylab::app {

namespace fs = std::filesystem;

namespace {

void configure(const Tree& tree, const fs::path& overlay, const fs::path& build) {
    // Warnings about what a stub leaves unused are no errors; -O1 and one variant of each
    // kernel compile faster, and the tests hold for any optimisation and variant.
    std::vector<std::string> command = {(tree.root / "cmake/configure.sh").string(),
                                        build.string(),
                                        "-G",
                                        "Ninja",
                                        "-DCMAKE_BUILD_TYPE=None",
                                        "-DCMAKE_CXX_FLAGS=-O1",
                                        "-DRAYLAB_STRICT=OFF",
                                        "-DRAYLAB_TESTS=OFF",
                                        "-DRAYLAB_VARIANTS=one",
                                        "-DRAYLAB_OVERLAY=" + overlay.string()};
    if (run_process({"ccache", "--version"}, {10}).succeeded())
        command.push_back("-DCMAKE_CXX_COMPILER_LAUNCHER=ccache");
    const ProcessResult result = run_process(command, {300, tree.root});
    if (!result.succeeded())
        throw std::runtime_error(
            fmt::format("configuring failed, {}:\n{}", why_failed(result), result.output));
}

} // namespace

// CMake looks for the labs in the overlay when it configures, and the next proof in this folder may
// be of another lab. So all of them must be there before.
ProofBuild::ProofBuild(const Tree& tree)
    : overlay_(tree.root / "build/proof/overlay"), proof_tree_{tree.root,
                                                               tree.root / "build/proof/build"} {
    for (const std::string& lab : lab_folders(tree.root))
        write_lab(read_lab_sources(find_lab(tree.root, lab)), {}, overlay_);
    configure(tree, overlay_, proof_tree_.build);
}

CheckReport ProofBuild::check(const LabSources& lab, const std::set<std::string>& stubbed,
                              const Variation* change, const std::vector<std::string>& tasks) {
    write_lab(lab, stubbed, overlay_, [&](const std::string& file, std::string text) {
        return change && change->file == file ? change->apply(text) : text;
    });
    const LabSheet laid_over = read_lab_sheet(overlay_, lab.sheet.folder);
    return check_tasks(proof_tree_, laid_over, tasks.empty() ? lab.sheet.task_ids() : tasks);
}

} // namespace raylab::app
