// Another program, run to its end.
#pragma once

#include <string>
#include <vector>

namespace raylab::bench {

struct ProcessResult {
    int exit_code = -1; // -1: it could not be started, or a signal ended it
    bool timed_out = false;
    double seconds = 0;  // wall clock, from start to end
    std::string output;  // standard output and error, the last 64 KiB
    std::string failure; // "timed out after 60 s", "could not be started: ..."; empty: it ran

    bool succeeded() const { return failure.empty() && exit_code == 0; }
};

// command[0] is looked up on PATH. After `limit` seconds it and its children are killed.
ProcessResult run_process(const std::vector<std::string>& command, double limit);

// Why it failed, in half a sentence: "exit status 3: ImportError: ...".
std::string why_failed(const ProcessResult& result);

} // namespace raylab::bench
