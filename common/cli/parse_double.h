// std::from_chars() for double, which Apple's library does not have yet.
#pragma once

#include <charconv>

namespace raylab {

// As std::from_chars(begin, end, value): no sign '+', no space and no hexadecimal number.
std::from_chars_result parse_double(const char* begin, const char* end, double& value);

// The same by std::strtod(): what the above does where the library cannot.
std::from_chars_result parse_double_by_strtod(const char* begin, const char* end, double& value);

} // namespace raylab
