// Another program, run to its end or to its limit.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace raylab {

struct ProcessOutcome {
    int exit_code = -1;     // -1: it was killed by a signal
    int signal = 0;         // that killed it, 0: none
    bool timed_out = false; // it was killed because its time was up
    std::string output;     // standard output and standard error, as they came
    double seconds = 0;

    bool succeeded() const { return exit_code == 0; }
};

// Runs command[0], found on PATH, with the other words as its arguments, in the given folder.
// Standard input is empty. When the time is up, it is killed with all its children. `watch` sees
// the output so far whenever there is more. Throws std::system_error if it cannot be started.
ProcessOutcome run_process(const std::vector<std::string>& command,
                           const std::filesystem::path& folder, double limit_seconds,
                           const std::function<void(const std::string& output)>& watch = nullptr);

} // namespace raylab
