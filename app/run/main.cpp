// raylab-run: the program behind `raylab run`. It links no lab, and works while a lab does not
// compile.
#include "app/run/debug.h"
#include "app/run/run.h"
#include "common/cli/files.h"
#include "common/cli/interrupt.h"
#include "common/cli/own_tree.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>

namespace raylab::app {

namespace {

constexpr const char* examples =
    "Examples:\n"
    "  raylab run reduce.cu\n"
    "  raylab run reduce.cu --machine all         every mistake that the machine knows\n"
    "  raylab run main.cu kernels.cu --include ../common -- 1024 input.txt\n"
    "  raylab run reduce.cu --gdb                 look inside: common/simt/debugging.md\n"
    "  raylab run assignment/ --machine races --sarif > races.sarif\n"
    "Machines: plain (fast: crashes, barriers, masks, endless loops), watch (every load and store "
    "of a\n"
    "kernel: bounds, races, memory that nobody wrote), bounds (the sanitizers, in host code too), "
    "races\n"
    "(the thread sanitizer), order (does the output depend on it?), memory (for each line the "
    "lanes\n"
    "that take part, sectors and bank conflicts), all (the first three and order).\n"
    "Exit code 0: nothing found but notes; 1: findings, or the program failed; 2: wrong usage, or "
    "it does "
    "not\n"
    "compile; 3: raylab failed, or no kernel was run.";

struct Formats {
    bool json = false, sarif = false, github = false;
    Format chosen() const {
        return json ? Format::json : sarif ? Format::sarif : github ? Format::github : Format::text;
    }
};

void add_options(CLI::App& app, RunOptions& options, Formats& formats) {
    app.add_option("FILES", options.inputs, "sources (.cu, .cpp, .c), or a folder with them")
        ->required();
    app.add_option("--machine", options.machine,
                   "plain, bounds, watch, races, order, memory or all")
        ->check(CLI::IsMember({"plain", "bounds", "races", "watch", "order", "memory", "all"}))
        ->capture_default_str();
    app.add_option("--order", options.order, "in which threads and blocks get their turn")
        ->check(CLI::IsMember({"forward", "reverse", "random"}));
    app.add_option("--seed", options.seed, "of the order random")->capture_default_str();
    app.add_option("--include", options.include_folders,
                   "a folder with headers; may be given again")
        ->allow_extra_args(false)
        ->check(CLI::ExistingDirectory);
    app.add_option("--define", options.defines, "NAME or NAME=VALUE for the preprocessor")
        ->allow_extra_args(false);
    auto* json = app.add_flag("--json", formats.json, "print a JSON object");
    auto* sarif = app.add_flag("--sarif", formats.sarif, "print SARIF 2.1.0");
    auto* github =
        app.add_flag("--github", formats.github, "print annotations of a GitHub workflow");
    json->excludes(sarif)->excludes(github);
    sarif->excludes(github);
    app.add_flag("--gdb", options.gdb, "start gdb with the program, stopped at its beginning")
        ->excludes("--machine")
        ->excludes(json)
        ->excludes(sarif)
        ->excludes(github);
    app.add_flag("--raw", options.raw, "show what the sanitizers wrote, too");
    app.add_option(
           "--time-limit", options.time_limit,
           "seconds for the program (bounds: 3 times as many; watch and races: 6; memory: 12)")
        ->check(CLI::Range(0.1, 86400.0))
        ->capture_default_str();
    app.add_option("--keep", options.keep, "keep what was compiled in this folder");
    app.footer(examples);
}

int run_command(int argc, char** argv) {
    // Everything after -- is the program's.
    const auto end = std::find(argv, argv + argc, std::string("--"));
    RunOptions options;
    if (end != argv + argc) options.arguments.assign(end + 1, argv + argc);
    CLI::App app("Compile unmodified CUDA for the CPU machine, run it, and name its mistakes.",
                 "raylab");
    app.require_subcommand(1);
    CLI::App* run = app.add_subcommand(
        "run", "Compile unmodified CUDA for the CPU machine, run it, and name its mistakes.");
    Formats formats;
    add_options(*run, options, formats);
    try {
        app.parse(int(end - argv), argv);
    } catch (const CLI::ParseError& error) {
        const bool asked_for_help = error.get_exit_code() == 0;
        app.exit(error);
        return int(asked_for_help ? ExitCode::success : ExitCode::bad_usage);
    }
    options.format = formats.chosen();
    if (!options.order.empty() && (options.machine == "order" || options.machine == "all"))
        throw UsageError("--order is for one run, and --machine " + options.machine +
                         " compares all orders: leave one of them out");
    const Tree tree = {RAYLAB_ROOT};
    expect_own_tree(RAYLAB_PROGRAM_FILE, tree.root);
    if (options.gdb) return debug(tree, options);
    const Result result = app::run(tree, options);
    const auto print = options.format == Format::json    ? to_json
                       : options.format == Format::sarif ? to_sarif
                       : options.format == Format::github
                           ? to_github
                           : static_cast<std::string (*)(const Result&)>(to_text);
    fmt::print("{}", print(result));
    return exit_code(result);
}

} // namespace

} // namespace raylab::app

int main(int argc, char** argv) {
    using namespace raylab;
    catch_signals();
    const auto fail = [](const char* what, ExitCode code) {
        fmt::print(stderr, "raylab: {}\n", what);
        return static_cast<int>(code);
    };
    try {
        return app::run_command(argc, argv);
    } catch (const app::UsageError& error) {
        return fail(error.what(), ExitCode::bad_usage);
    } catch (const FileError& error) {
        return fail(error.what(), error.code);
    } catch (const std::filesystem::filesystem_error& error) {
        const FileError translated = file_error(error);
        return fail(translated.what(), translated.code);
    } catch (const std::exception& error) {
        return fail(error.what(), ExitCode::tool_failed);
    }
}
