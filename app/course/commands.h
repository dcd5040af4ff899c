// The commands that must work while a lab does not compile: their program links no lab.
#pragma once

#include "app/course/check_run.h"

#include <CLI/CLI.hpp>

#include <functional>

namespace raylab::app {

using Run = std::function<ExitCode()>;

Run add_check(CLI::App& app, const Tree& tree);
Run add_prove(CLI::App& app, const Tree& tree);
Run add_update(CLI::App& app, const Tree& tree);
Run add_release(CLI::App& app, const Tree& tree);

} // namespace raylab::app
