// What nvcc refuses and g++ does not: kernels that use the host's functions and variables, host
// code that calls a __device__ function, and a kernel that is called without <<< >>>.
//
// On the CPU machine all of these just work: everything is one memory and one kind of function.
// clang knows CUDA's rules; it reads the program with the machine's headers and compiles nothing.
// By the way it warns of local variables without a value, and of printf() whose format is not that
// of its arguments, as nvcc does.
#pragma once

#include "app/run/run_options.h"
#include "common/simt/finding.h"

#include <string>
#include <vector>

namespace raylab::app {

struct HostCode {
    std::vector<simt::Finding> findings;
    std::string unchecked; // why nothing is known, half a sentence; empty: it was checked
};

// Takes about a second a file.
HostCode host_code_in_kernels(const Tree& tree, const RunOptions& options,
                              const std::vector<std::string>& sources);

// The findings in clang's words; what is declared below one of the folders is not the program's.
// Sets `understood` to false if there is an error of another kind.
std::vector<simt::Finding> findings_of_clang(const std::string& words,
                                             const std::vector<std::string>& folders,
                                             bool& understood);

} // namespace raylab::app
