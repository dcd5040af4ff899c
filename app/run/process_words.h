// Words from other programs.
#pragma once

#include <string>

namespace raylab::app {

// The last lines of a long text, each with its line break.
inline std::string last_lines(const std::string& text, int count = 30) {
    std::size_t from = text.size();
    if (from > 0 && text.back() == '\n') --from;
    while (count-- > 0 && from != text.npos && from > 0) from = text.rfind('\n', from - 1);
    std::string lines = from == text.npos || from == 0 ? text : text.substr(from + 1);
    if (!lines.empty() && lines.back() != '\n') lines += '\n';
    return lines;
}

} // namespace raylab::app
