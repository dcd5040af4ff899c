// Lists as text. (fmt::join would do it, but g++ 12 warns inside it at -O3.)
#pragma once

#include <fmt/format.h>

namespace raylab::bench {

// "4, 16".
template <class Values> std::string joined(const Values& values, const char* separator) {
    std::string text;
    for (const auto& value : values) {
        if (!text.empty()) text += separator;
        text += fmt::format("{}", value);
    }
    return text;
}

} // namespace raylab::bench
