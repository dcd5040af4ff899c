// Runs the program, and reads what the engine wrote down meanwhile.
#pragma once

#include "app/run/machine.h"
#include "common/cli/process.h"
#include "common/simt/finding.h"

#include <optional>

namespace raylab::app {

struct Execution {
    std::string mode;  // plain, bounds, races or order
    std::string order; // of the threads; empty: the program's own
    ProcessResult process;
    std::vector<simt::Finding> findings;
    std::optional<simt::RunSummary> summary; // empty: no kernel was run
    std::vector<simt::AccessCost> costs;     // of the mode memory
    std::string raw;                         // what sanitizers wrote
};

enum class Output { shown, to_errors, hidden };

// `show`: where the program's standard output goes while it runs; its standard error is shown
// unless that is hidden. Throws std::runtime_error if the program cannot be started.
Execution execute(const Mode& mode, const std::filesystem::path& program, const std::string& order,
                  const RunOptions& options, Output show);

} // namespace raylab::app
