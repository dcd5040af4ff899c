// The report, for people and for programs.
#pragma once

#include "app/run/execute.h"

namespace raylab::app {

struct Result {
    std::vector<std::string> sources;
    std::vector<Execution> executions; // empty: the program does not compile
    std::vector<simt::Finding> findings;
    std::string compiler;  // its words, if it does not compile
    std::string unchecked; // host code in kernels: why nothing is known of it; empty: checked
};

std::string to_text(const Result& result);
std::string to_json(const Result& result);   // one object
std::string to_sarif(const Result& result);  // SARIF 2.1.0
std::string to_github(const Result& result); // annotations of a workflow

// What was looked at, in one line: "plain: 1 launch, 64 threads, 2 KiB allocated".
std::string what_was_checked(const Execution& execution);

} // namespace raylab::app
