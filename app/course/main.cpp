// raylab-check: the program behind `raylab check`, `update`, `prove` and `release`.
#include "app/course/commands.h"
#include "app/program.h"
#include "common/cli/interrupt.h"
#include "common/cli/own_tree.h"

#include <fmt/format.h>

int main(int argc, char** argv) {
    using namespace raylab;
    catch_signals();
    const app::Tree tree = {RAYLAB_ROOT, RAYLAB_BUILD};
    CLI::App cli("raylab: check a lab's tasks, and hand labs out", "raylab");
    cli.require_subcommand(1);
    std::map<CLI::App*, app::Run> runs;
    const auto add = [&](const char* name, app::Run (*command)(CLI::App&, const app::Tree&)) {
        CLI::App* sub = cli.add_subcommand(name);
        runs[sub] = command(*sub, tree);
    };
    add("check", app::add_check);
    add("update", app::add_update);
    add("prove", app::add_prove);
    add("release", app::add_release);
    return app::run_program<CourseError>(cli, argc, argv, [&] {
        expect_own_tree(RAYLAB_PROGRAM_FILE, tree.root);
        if (const std::string overlay = RAYLAB_LAID_OVER; !overlay.empty())
            throw std::runtime_error(fmt::format("{} builds the labs in {} instead of this tree's: "
                                                 "nothing was done; call the script ./raylab, "
                                                 "which configures anew",
                                                 tree.build.string(), overlay));
        return runs.at(cli.get_subcommands().front())();
    });
}
