// From sources to a program of the CPU machine.
#pragma once

#include "app/run/machine.h"
#include "common/simt/finding.h"

#include <string>
#include <vector>

namespace raylab::app {

// The sources that the inputs name: files as they are, of a folder every .cu, .cpp and .c in it.
// Throws UsageError.
std::vector<std::string> sources_of(const std::vector<std::string>& inputs);

struct BuiltProgram {
    std::filesystem::path file;          // empty: it does not compile
    std::string words;                   // of the rewriter, the compiler and the linker
    std::vector<simt::Finding> findings; // the same, as far as it is about the sources
};

// Rewrites, compiles and links the sources into `folder`; shows progress. Throws
// std::runtime_error if a tool cannot be run.
BuiltProgram build_program(const Tree& tree, const Machine& machine,
                           const std::vector<std::string>& sources, const RunOptions& options,
                           const std::filesystem::path& folder);

} // namespace raylab::app
