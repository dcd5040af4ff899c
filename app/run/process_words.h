// Words to other programs, and from them.
#pragma once

#include <string>

namespace raylab::app {

// A word of a command for the shell.
inline std::string in_quotes(const std::string& word) {
    std::string text = "'";
    for (char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return text + "'";
}

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
