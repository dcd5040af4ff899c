// The error of everything that reads a lab: made to be read by the person who wrote it.
#pragma once

#include <stdexcept>

namespace raylab {

// what() is `file:line: what is wrong; what to do`, with a column where there is one.
struct CourseError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

} // namespace raylab
