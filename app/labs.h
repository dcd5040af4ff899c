// All labs in one list: only the program and the tests of all labs together know more than one.
#pragma once

#include "common/render/renderer.h"

#include <stdexcept>
#include <string>
#include <vector>

namespace raylab::app {

// Wrong input: printed as it stands, exit code 2.
struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// All labs, in the order of their numbers.
const std::vector<Lab>& labs();

// By number ("02", "2") or folder ("02_iterative"). Throws UsageError with the list of labs.
const Lab& find_lab(const std::string& name);

} // namespace raylab::app
