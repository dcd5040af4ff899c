// What the programs beside app/raylab have in common: an error becomes a sentence and an exit code.
#pragma once

#include "common/cli/files.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <functional>

namespace raylab::app {

// Reads the command line, does the work, and returns the exit code. An exception of one of the
// types `Usage` says that the user can mend it: exit code 2.
template <class... Usage>
int run_program(CLI::App& cli, int argc, char** argv, const std::function<ExitCode()>& work) {
    const auto fail = [](const std::exception& error, ExitCode code) {
        fmt::print(stderr, "raylab: {}\n", error.what());
        return static_cast<int>(code);
    };
    try {
        cli.parse(argc, argv);
        return static_cast<int>(work());
    } catch (const CLI::ParseError& error) {
        const bool asked_for_help = error.get_exit_code() == 0;
        cli.exit(error);
        return static_cast<int>(asked_for_help ? ExitCode::success : ExitCode::bad_usage);
    } catch (const FileError& error) {
        return fail(error, error.code);
    } catch (const std::filesystem::filesystem_error& error) {
        const FileError translated = file_error(error);
        return fail(translated, translated.code);
    } catch (const std::exception& error) {
        const bool is_usage = (... || (dynamic_cast<const Usage*>(&error) != nullptr));
        return fail(error, is_usage ? ExitCode::bad_usage : ExitCode::tool_failed);
    }
}

} // namespace raylab::app
