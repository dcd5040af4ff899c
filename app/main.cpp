// raylab: the program behind the script of the same name.
#include "app/commands.h"
#include "app/errors.h"
#include "app/options.h"
#include "common/cli/interrupt.h"
#include "common/cli/memory.h"
#include "common/cli/own_tree.h"

#include <map>

namespace raylab::app {

namespace {

struct Command {
    const char* name;
    Run (*add)(CLI::App&);
};

constexpr Command commands[] = {
    {"demo", add_demo},           {"render", add_render},         {"compare", add_compare},
    {"bench", add_bench},         {"bench-rays", add_bench_rays}, {"rare-cases", add_rare_cases},
    {"reference", add_reference}, {"scenes", add_scenes},         {"export", add_export},
    {"import", add_import},       {"debug", add_debug},
};

// Parses the command line and runs the command. Errors of parsing return 2; main() handles what a
// command throws.
int run(int argc, char** argv) {
    CLI::App app("raylab: a teaching lab for parallel path tracing", "raylab");
    app.require_subcommand(1);
    app.footer("`raylab test` builds and runs every test. `raylab COMMAND --help` has examples.\n"
               "Exit codes: 0 done or passed, 1 judged and failed, 2 wrong usage or input,\n"
               "3 the tool itself failed.");
    std::map<CLI::App*, Run> runs;
    for (const Command& command : commands) {
        CLI::App* sub = app.add_subcommand(command.name);
        runs[sub] = command.add(*sub);
    }
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        const bool asked_for_help = error.get_exit_code() == 0;
        app.exit(error);
        return static_cast<int>(asked_for_help ? ExitCode::success : ExitCode::bad_usage);
    }
    expect_own_tree(RAYLAB_PROGRAM_FILE, RAYLAB_ROOT);
    return static_cast<int>(runs.at(app.get_subcommands().front())());
}

} // namespace

} // namespace raylab::app

int main(int argc, char** argv) {
    raylab::spare_address_space();
    raylab::catch_signals();
    try {
        return raylab::app::run(argc, argv);
    } catch (...) {
        return static_cast<int>(raylab::app::report_exception());
    }
}
