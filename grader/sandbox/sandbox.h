// Runs a program that nobody trusts: a submission's build, its tests, its renders.
//
// Such a program sees the files that it is given and no others, has no network, and ends with all
// that it has started. What it may take of time, memory, processes, disk and output is limited. The
// verdict on it comes from outside: from its exit status, the clock, and the counters of the
// kernel.
#pragma once

#include "grader/sandbox/tier.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace raylab::sandbox {

// A file or folder, and where the program sees it. Where the tier has no mounts (Isolation::maps),
// both are the same.
struct Bind {
    std::filesystem::path from, to;
    Bind(const std::filesystem::path& same) : from(same), to(same) {}
    Bind(const std::filesystem::path& f, const std::filesystem::path& t) : from(f), to(t) {}
};

struct Limits {
    double wall_seconds = 30;
    double cpu_seconds = 60;                   // of each process
    std::uint64_t memory = 1ull << 30;         // bytes of all its processes and its tmpfs together
    std::uint64_t file_size = 64ull << 20;     // bytes of a file that it writes
    std::uint64_t output = 1ull << 20;         // bytes of standard output and error together
    std::uint64_t private_files = 64ull << 20; // bytes below its /tmp
    int processes = 64;                        // and threads
};

struct SandboxOptions {
    std::vector<Bind> readable = {}; // beside /usr and what belongs to it
    std::vector<Bind> writable = {}; // owned by the sandbox's user: see WorkFolder
    std::filesystem::path folder = "/";
    std::map<std::string, std::string> environment = {}; // beside PATH, LANG and HOME; nothing else
    std::map<int, int> handles = {}; // number in the program (3 to 9) -> this process's descriptor
    Limits limits = {};
    bool whole_output = false; // else Outcome::output is cut in the middle
};

enum class End {
    exited,        // by itself: see exit_code
    crashed,       // by a signal: see signal
    time_limit,    // wall clock or processor
    memory_limit,  // the kernel ended it
    output_limit,  // more on standard output and error, or in a file, than allowed
    process_limit, // more processes or threads than allowed, and it ended in failure
    not_started,   // the sandbox's own trouble: see trouble
};
const char* name(End end); // "EXITED", "TIME_LIMIT", ...

struct Outcome {
    End end = End::not_started;
    int exit_code = -1, signal = 0;
    std::string output;  // as the bytes came
    std::string trouble; // why it was not started
    double seconds = 0, cpu_seconds = 0;
    std::uint64_t peak_memory = 0; // bytes; 0: this tier cannot tell
    Tier tier = Tier::limited;

    bool succeeded() const { return end == End::exited && exit_code == 0; }
};

// Runs command[0], an absolute path, with its arguments. When it returns, nothing of the program
// runs any more. Errors are told in the outcome; throws only std::invalid_argument for wrong
// options.
Outcome run(const std::vector<std::string>& command, const SandboxOptions& options,
            const Isolation& isolation = best_isolation());

// "it did not end within 30 s".
std::string why(const Outcome& outcome, const Limits& limits);

} // namespace raylab::sandbox
