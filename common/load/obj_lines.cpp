#include "common/load/obj_lines.h"

#include <algorithm>

namespace raylab {
namespace {

constexpr std::string_view blanks = " \t\v\f";

} // namespace

ObjLines::ObjLines(std::string_view text) : text_(text) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (text_.starts_with(byte_order_mark)) text_.remove_prefix(byte_order_mark.size());
}

const std::vector<ObjWord>& ObjLines::next() {
    words_.clear();
    rest_ = {};
    bool goes_on = false;
    while (!text_.empty() && (goes_on || words_.empty())) {
        ++line_;
        const std::size_t end = std::min(text_.find_first_of("\r\n"), text_.size());
        std::string_view line = text_.substr(0, end);
        text_.remove_prefix(end);
        if (!text_.empty()) text_.remove_prefix(text_.starts_with("\r\n") ? 2 : 1);
        line = line.substr(0, line.find('#'));
        const std::size_t last = line.find_last_not_of(blanks);
        goes_on = last != line.npos && line[last] == '\\';
        split(line.substr(0, goes_on ? last : last == line.npos ? 0 : last + 1));
    }
    return words_;
}

void ObjLines::split(std::string_view line) {
    const bool first = words_.empty();
    for (std::size_t begin = 0; (begin = line.find_first_not_of(blanks, begin)) != line.npos;) {
        const std::size_t end = std::min(line.find_first_of(blanks, begin), line.size());
        words_.push_back({line.substr(begin, end - begin), line_, int(begin) + 1});
        begin = end;
    }
    if (first && words_.size() > 1) rest_ = line.substr(std::size_t(words_[1].column) - 1);
}

} // namespace raylab
