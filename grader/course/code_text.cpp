#include "grader/course/code_text.h"

#include <algorithm>
#include <cctype>

namespace raylab {

namespace {

constexpr std::string_view openers = "([{", closers = ")]}";

bool is_chain(char c) { return is_word(c) || c == '.' || c == ':'; }

void blank(std::string& code, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < std::min(end, code.size()); ++i)
        if (code[i] != '\n') code[i] = ' ';
}

// Behind the literal that begins with a quote at `begin`.
std::size_t behind_literal(std::string_view code, std::size_t begin) {
    for (std::size_t i = begin + 1; i < code.size(); ++i) {
        if (code[i] == '\\')
            ++i;
        else if (code[i] == code[begin])
            return i + 1;
    }
    return code.size();
}

} // namespace

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

std::string without_comments(std::string code) {
    bool begins_line = true;
    for (std::size_t i = 0; i < code.size();) {
        std::size_t end = i;
        const bool digits = code[i] == '\'' && i > 0 && is_word(code[i - 1]); // 1'000
        if (code.compare(i, 2, "//") == 0 || (begins_line && code[i] == '#'))
            end = std::min(code.find('\n', i), code.size());
        else if (code.compare(i, 2, "/*") == 0)
            end = std::min(code.find("*/", i), code.size() - 2) + 2;
        else if (code[i] == '"' || (code[i] == '\'' && !digits))
            end = behind_literal(code, i);
        if (end > i) {
            blank(code, i, end);
            i = end;
            continue;
        }
        begins_line = code[i] == '\n' || (begins_line && code[i] == ' ');
        ++i;
    }
    return code;
}

std::size_t behind_bracket(std::string_view code, std::size_t open) {
    int depth = 0;
    for (std::size_t i = open; i < code.size(); ++i) {
        if (openers.find(code[i]) != openers.npos) ++depth;
        if (closers.find(code[i]) != closers.npos && --depth == 0) return i + 1;
    }
    return code.npos;
}

std::string_view operand_before(std::string_view code, std::size_t end) {
    std::size_t begin = end;
    while (begin > 0) {
        const char last = code[begin - 1];
        if (is_chain(last)) {
            --begin;
        } else if (last == ')' || last == ']') {
            int depth = 0;
            std::size_t open = begin;
            do {
                --open;
                if (closers.find(code[open]) != closers.npos) ++depth;
                if (openers.find(code[open]) != openers.npos) --depth;
            } while (depth > 0 && open > 0);
            if (depth > 0) return {};
            begin = open;
        } else {
            break;
        }
    }
    return code.substr(begin, end - begin);
}

std::string_view operand_from(std::string_view code, std::size_t begin) {
    std::size_t end = begin;
    while (end < code.size()) {
        if (is_chain(code[end])) {
            ++end;
        } else if (code[end] == '(' || code[end] == '[') {
            const std::size_t behind = behind_bracket(code, end);
            if (behind == code.npos) return {};
            end = behind;
        } else {
            break;
        }
    }
    return code.substr(begin, end - begin);
}

} // namespace raylab
