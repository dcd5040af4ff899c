// What `raylab run` does once its arguments are read.
#pragma once

#include "app/run/output.h"

namespace raylab::app {

// Builds the program for each mode that was asked for and runs it; shows progress, and what the
// program prints. Throws UsageError, std::runtime_error.
Result run(const Tree& tree, const RunOptions& options);

// 0 nothing found, 1 findings or a program that failed, 2 it does not compile, 3 no kernel was run.
int exit_code(const Result& result);

} // namespace raylab::app
