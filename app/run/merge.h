// The findings of several modes, as one list for people.
#pragma once

#include "app/run/execute.h"

namespace raylab::app {

// Findings of one kind at one place are one, of all the modes that saw it. What is wrong with an
// address is decided first: there is no race where memory ends.
std::vector<simt::Finding> merged(const std::vector<Execution>& executions);

} // namespace raylab::app
