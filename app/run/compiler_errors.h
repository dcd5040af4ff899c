// What rewriter, compiler and linker complain about, as findings in the student's sources.
#pragma once

#include "common/simt/finding.h"

#include <string>
#include <vector>

namespace raylab::app {

// An error in a header that a source led to is told at that source's line, where it is named.
std::vector<simt::Finding> compiler_errors(const std::string& words,
                                           const std::vector<std::string>& sources);

} // namespace raylab::app
