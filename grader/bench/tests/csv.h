// Reads what the benches write.
#pragma once

#include <string>
#include <vector>

namespace raylab::bench {

// Fields of one CSV text, quoted line ends included.
inline std::vector<std::vector<std::string>> parse_csv(const std::string& text) {
    std::vector<std::vector<std::string>> lines(1, {""});
    bool quoted = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '"' && quoted && i + 1 < text.size() && text[i + 1] == '"')
            lines.back().back() += text[++i];
        else if (c == '"')
            quoted = !quoted;
        else if (c == ',' && !quoted)
            lines.back().emplace_back();
        else if (c == '\n' && !quoted)
            lines.push_back({""});
        else if (c != '\r' || quoted)
            lines.back().back() += c;
    }
    lines.pop_back(); // after the last line end
    return lines;
}

} // namespace raylab::bench
