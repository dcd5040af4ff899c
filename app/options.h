// What the commands share: how a render is described on the command line, and how a command ends.
#pragma once

#include "app/labs.h"
#include "app/scene_changes.h"
#include "common/cli/exit_codes.h"

#include <CLI/CLI.hpp>

#include <functional>

namespace raylab::app {

// A command adds its options to a CLI::App and returns what to run once they are parsed.
using Run = std::function<ExitCode()>;

void add_scene_options(CLI::App& app, SceneChanges& changes);
void add_machine_options(CLI::App& app, MachineSettings& machine);

// The options of labs with a pool of rays.
void add_wavefront_options(CLI::App& app, WavefrontSettings& wavefront);

// Throws UsageError if such an option is given and the lab has no pool.
void check_wavefront_options(const Lab& lab, const WavefrontSettings& wavefront);

} // namespace raylab::app
