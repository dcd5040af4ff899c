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

// The options of labs with a pool of rays, and of those with a structure over the triangles.
void add_wavefront_options(CLI::App& app, WavefrontSettings& wavefront);
void add_accel_options(CLI::App& app, AccelSettings& accel);

// Throws UsageError if an option is given that is not for this lab.
void check_lab_options(const Lab& lab, const MachineSettings& machine);

} // namespace raylab::app
