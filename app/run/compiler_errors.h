// What rewriter, compiler and linker complain about, as findings in the student's sources.
#pragma once

#include "common/simt/finding.h"

#include <string>
#include <vector>

namespace raylab::app {

// An error in a header that a source led to is told at that source's line, where it is named.
// `folder`: where the sources were compiled; the linker puts it in front of names.
std::vector<simt::Finding> compiler_errors(const std::string& words,
                                           const std::vector<std::string>& sources,
                                           const std::string& folder);

} // namespace raylab::app
