#include "grader/sandbox/sandbox.h"

#include <fmt/format.h>

#include <cstring>

namespace raylab::sandbox {

const char* name(End end) {
    switch (end) {
    case End::exited:
        return "EXITED";
    case End::crashed:
        return "CRASH";
    case End::time_limit:
        return "TIME_LIMIT";
    case End::memory_limit:
        return "MEMORY_LIMIT";
    case End::output_limit:
        return "OUTPUT_LIMIT";
    case End::process_limit:
        return "PROCESS_LIMIT";
    case End::not_started:
        return "INTERNAL";
    }
    return "";
}

std::string why(const Outcome& outcome, const Limits& limits) {
    switch (outcome.end) {
    case End::exited:
        return fmt::format("it ended with exit code {}", outcome.exit_code);
    case End::crashed:
        return fmt::format("it crashed ({})", strsignal(outcome.signal));
    case End::time_limit:
        return fmt::format(
            "it did not end within {:.0f} s, or took more than {:.0f} s of the processor",
            limits.wall_seconds, limits.cpu_seconds);
    case End::memory_limit:
        return fmt::format("it took more than {} MiB of memory", limits.memory >> 20);
    case End::output_limit:
        return fmt::format("it printed more than {} KiB, or wrote a file of more than {} MiB",
                           limits.output >> 10, limits.file_size >> 20);
    case End::process_limit:
        return fmt::format("it started more than {} processes or threads", limits.processes);
    case End::not_started:
        return "the sandbox could not start it: " + outcome.trouble;
    }
    return "";
}

} // namespace raylab::sandbox
