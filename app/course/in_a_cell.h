// A text as it may stand in one cell of a table in Markdown.
#pragma once

#include <string>

namespace raylab::app {

inline std::string in_a_cell(std::string text) {
    for (std::size_t at = 0; (at = text.find_first_of("|\n", at)) != text.npos; at += 2)
        text.replace(at, 1, text[at] == '|' ? "\\|" : "; ");
    return text;
}

} // namespace raylab::app
