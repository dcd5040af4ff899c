// The error of everything that reads what students have sent: made to be read by a person.
#pragma once

#include <stdexcept>

namespace raylab {

// what() is one sentence: the place, what is wrong, what to do.
struct SubmissionError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

} // namespace raylab
