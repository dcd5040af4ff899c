// The commands for a class of submissions: their program links no lab.
#pragma once

#include "common/cli/exit_codes.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <functional>

namespace raylab::app {

using Run = std::function<ExitCode()>;

Run add_grade_class(CLI::App& app, const std::filesystem::path& root, const std::string& grader);

} // namespace raylab::app
