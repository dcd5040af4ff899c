// Another program, run to its end or to its limit.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace raylab {

struct ProcessResult {
    int exit_code = -1; // -1: it could not be started, or a signal ended it
    int signal = 0;     // that ended it; 0: none
    bool started = false;
    bool timed_out = false;
    double seconds = 0; // wall clock, from start to end
    std::string output; // standard output and error as they came, at least the last 4 MiB

    bool succeeded() const { return exit_code == 0; }
};

struct ProcessOptions {
    double limit_seconds;
    std::filesystem::path folder = {}; // it runs there; empty: where this program runs
    std::function<void(const std::string& output)> watch = {}; // sees the output when there is more
};

// Runs command[0], found on PATH, with the other words as its arguments and an empty standard
// input. After the limit it is killed with its children, and so it is if a signal ends this
// program. What goes wrong is in the result.
ProcessResult run_process(const std::vector<std::string>& command, const ProcessOptions& options);

// Why it did not succeed, in half a sentence: "exit status 3: ImportError: no module mitsuba".
std::string why_failed(const ProcessResult& result);

} // namespace raylab
