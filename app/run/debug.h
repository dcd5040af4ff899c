// `raylab run --gdb`: the program in the debugger.
#pragma once

#include "app/run/run_options.h"

namespace raylab::app {

// Builds the program with debug information and without optimisation, and starts gdb with it; the
// terminal is gdb's until it ends. Returns the exit code: 0, or 2 if the program does not compile.
// Throws UsageError, std::runtime_error.
int debug(const Tree& tree, const RunOptions& options);

} // namespace raylab::app
