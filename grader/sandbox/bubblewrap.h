// The command line of bubblewrap, which makes the namespaces of tier 1.
#pragma once

#include "grader/sandbox/sandbox.h"

namespace raylab::sandbox {

std::string bubblewrap_program(); // its path; empty: not installed

// The folders of the system that every program needs to start, and the compiler to work.
std::vector<std::filesystem::path> system_folders();

// bubblewrap reads the seccomp filter from `filter` and tells on `status` how the command ended.
std::vector<std::string> in_bubblewrap(const std::vector<std::string>& command,
                                       const SandboxOptions& options, int filter, int status);

} // namespace raylab::sandbox
