#include "common/cli/parse_double.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <string>
#include <version>

namespace raylab {

std::from_chars_result parse_double_by_strtod(const char* begin, const char* end, double& value) {
    // What strtod() reads and from_chars() does not: "0x10", of which that reads the 0, and numbers
    // behind a sign or a space.
    const std::string text(begin,
                           std::find_if(begin, end, [](char c) { return c == 'x' || c == 'X'; }));
    if (text.empty() || text[0] == '+' || text[0] <= ' ')
        return {begin, std::errc::invalid_argument};
    char* stop = nullptr;
    errno = 0;
    const double number = std::strtod(text.c_str(), &stop);
    if (stop == text.c_str()) return {begin, std::errc::invalid_argument};
    const char* behind = begin + (stop - text.c_str());
    // A number below the normal ones is in range, though strtod() may call it out of range.
    if (errno == ERANGE && (number == 0 || std::isinf(number)))
        return {behind, std::errc::result_out_of_range};
    value = number;
    return {behind, std::errc()};
}

std::from_chars_result parse_double(const char* begin, const char* end, double& value) {
#if defined(__cpp_lib_to_chars)
    return std::from_chars(begin, end, value);
#else
    return parse_double_by_strtod(begin, end, value);
#endif
}

} // namespace raylab
