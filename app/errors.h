// One sentence for a person, and the program's exit status, for whatever a command threw.
#pragma once

#include "common/cli/exit_codes.h"

namespace raylab::app {

// In a catch clause: prints what the exception says to standard error.
ExitCode report_exception();

} // namespace raylab::app
