// What the commands share: how a render is described on the command line, and how a command ends.
#pragma once

#include "common/cli/exit_codes.h"
#include "common/render/renderer.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace raylab::app {

// A command adds its options to `app` and returns what to run once they are parsed.
using Run = std::function<ExitCode()>;

// Wrong input: printed as it stands, exit code 2.
struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// Changes to a scene's `render` and `film` blocks.
struct SceneChanges {
    std::optional<int> spp, depth, width, height;
    std::optional<std::uint32_t> seed;
    std::optional<std::string> integrator, sampler, direct_light;
    std::optional<bool> roulette;
};

void add_scene_options(CLI::App& app, SceneChanges& changes);
void add_machine_options(CLI::App& app, MachineSettings& machine);

// Loads a scene by name or path and applies the changes; the result is validated again.
Scene load_changed_scene(const std::string& name, const SceneChanges& changes);

// All labs in order.
const std::vector<Lab>& labs();

// By number ("02", "2") or folder ("02_iterative"). Throws UsageError with the list of labs.
const Lab& find_lab(const std::string& name);

} // namespace raylab::app
