// Another program, run to its end or to its limit.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace raylab {

struct ProcessResult {
    int exit_code = -1; // -1: it could not be started, or a signal ended it
    int signal = 0;     // the signal that ended it; 0: none
    bool started = false;
    bool timed_out = false;
    double seconds = 0; // wall clock, from start to end
    std::string output; // standard output and error as they came, at least the last 4 MiB; the
                        // latter only if the options want it here

    bool succeeded() const { return exit_code == 0; }
};

struct ProcessOptions {
    double limit_seconds;
    std::filesystem::path folder = {}; // the program's folder; empty: this program's
    std::function<void(const std::string& output)> watch = {}; // gets the output when there is more
    std::function<void()> tick = {}; // is called now and then while there is nothing to see
    enum class Errors { in_output, passed_on, to_file } errors = Errors::in_output;
    std::filesystem::path error_file = {}; // of to_file, in place of what was there
    // More than the limit: so long may a program run that other programs keep waiting (deadline.h).
    double limit_on_a_busy_machine = 0;
};

// Runs command[0], found on PATH, with the other words as its arguments and an empty standard
// input. When the limit is over, or when a signal ends this program, the child is killed with its
// own children. Errors are reported in the result, and nothing is thrown.
ProcessResult run_process(const std::vector<std::string>& command, const ProcessOptions& options);

// A word of a command for the shell.
std::string in_quotes(const std::string& word);

// Why it did not succeed, in half a sentence: "exit status 3: ImportError: no module mitsuba".
std::string why_failed(const ProcessResult& result);

} // namespace raylab
