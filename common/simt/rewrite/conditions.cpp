// Conditional parts of a source; see conditions.h.
#include "common/simt/rewrite/conditions.h"

namespace raylab::simt {

Conditions::Conditions(std::string_view source, const std::vector<Token>& tokens) {
    auto word = [&](size_t i) { return i < tokens.size() ? tokens[i].spelling : ""; };
    std::vector<Part> open;
    for (size_t i = 0; i + 1 < tokens.size(); ++i) {
        if (word(i) != "#") continue;
        size_t begin = tokens[i].begin;
        if (word(i + 1) == "define") {
            size_t end = source.find('\n', begin);
            while (end != source.npos && source[end - 1] == '\\') end = source.find('\n', end + 1);
            parts_.push_back({begin, end});
        }
        if (word(i + 1) == "if" || word(i + 1) == "ifdef" || word(i + 1) == "ifndef") {
            // #ifndef NAME, #define NAME at the very beginning
            bool guard = i == 0 && word(1) == "ifndef" && word(3) == "#" && word(4) == "define" &&
                         word(5) == word(2);
            open.push_back({begin, guard ? begin : source.npos});
        }
        if (word(i + 1) == "endif" && !open.empty()) {
            if (open.back().end == source.npos) parts_.push_back({open.back().begin, begin});
            open.pop_back();
        }
    }
}

bool Conditions::may_be_skipped(size_t offset) const {
    for (const Part& part : parts_)
        if (part.begin <= offset && offset < part.end) return true;
    return false;
}

} // namespace raylab::simt
