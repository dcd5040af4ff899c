// The commands of the program that grades: it links no lab.
#pragma once

#include "common/cli/exit_codes.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <functional>

namespace raylab::app {

// Where the program's own tree and build are, and the program that draws references.
struct GraderTree {
    std::filesystem::path root, build, draw;
    std::filesystem::path cache() const { return root / "build/grade"; }
};

using Run = std::function<ExitCode()>;

Run add_grade(CLI::App& app, const GraderTree& tree);
Run add_autograder(CLI::App& app, const GraderTree& tree);
Run add_doctor(CLI::App& app, const GraderTree& tree);

} // namespace raylab::app
