#include "grader/course/code_edits.h"

#include "grader/course/code_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <regex>

namespace raylab {

namespace {

constexpr const char *deleted = "statement deleted",
                     *unguarded = "barrier, atomic or fence removed",
                     *flipped_comparison = "comparison flipped", *shifted_limit = "limit shifted",
                     *flipped_operator = "operator flipped", *off_by_one = "constant off by one",
                     *shifted_index = "index shifted", *swapped = "operands swapped";

// What stands in the place of a binary operator, and what kind of slip that is.
struct Slip {
    const char *kind, *with;
};

const std::multimap<std::string, Slip>& slips() {
    static const std::multimap<std::string, Slip> all = {
        {"<", {flipped_comparison, ">"}},   {"<", {shifted_limit, "<="}},
        {"<=", {flipped_comparison, ">="}}, {"<=", {shifted_limit, "<"}},
        {">", {flipped_comparison, "<"}},   {">", {shifted_limit, ">="}},
        {">=", {flipped_comparison, "<="}}, {">=", {shifted_limit, ">"}},
        {"==", {flipped_comparison, "!="}}, {"!=", {flipped_comparison, "=="}},
        {"&&", {flipped_operator, "||"}},   {"||", {flipped_operator, "&&"}},
        {"+", {flipped_operator, "-"}},     {"-", {flipped_operator, "+"}},
        {"*", {flipped_operator, "/"}},     {"/", {flipped_operator, "*"}},
        {"%", {flipped_operator, "/"}},     {"&", {flipped_operator, "|"}},
        {"|", {flipped_operator, "&"}},     {"^", {flipped_operator, "|"}},
        {"<<", {flipped_operator, ">>"}},   {">>", {flipped_operator, "<<"}},
        {"+=", {flipped_operator, "-="}},   {"-=", {flipped_operator, "+="}},
        {"*=", {flipped_operator, "/="}},   {"/=", {flipped_operator, "*="}},
        {"&=", {flipped_operator, "|="}},   {"|=", {flipped_operator, "&="}},
        {"<<=", {flipped_operator, ">>="}}, {">>=", {flipped_operator, "<<="}}};
    return all;
}

bool is_space(char c) { return c == ' ' || c == '\n'; }

class Finder {
  public:
    explicit Finder(const std::string& code) : written_(code), code_(without_comments(code)) {}

    std::vector<CodeEdit> find() {
        for (std::size_t i = 0; i < code_.size(); ++i) {
            follow_brackets(i);
            if (begins_statement(i)) statement(i);
            if (i > 0 && is_space(code_[i - 1]) && !is_space(code_[i])) binary_operator(i);
            unary_operator(i);
            constant(i);
            if (code_[i] == '[') index(i);
            if (code_[i] == '(') two_arguments(i);
            if (code_.compare(i, 10, "atomicAdd(") == 0) plain_addition(i);
        }
        std::stable_sort(edits_.begin(), edits_.end(),
                         [](const CodeEdit& a, const CodeEdit& b) { return a.at < b.at; });
        return std::move(edits_);
    }

  private:
    void edit(const char* kind, std::size_t at, std::size_t size, const std::string& with) {
        edits_.push_back({kind, at, size, with});
    }
    std::string text(std::size_t begin, std::size_t end) const {
        return code_.substr(begin, end - begin);
    }
    // A part of code_, with the literals in it.
    std::string written(std::string_view part) const {
        return written_.substr(static_cast<std::size_t>(part.data() - code_.data()), part.size());
    }
    // Keeps the brackets that are open before i.
    void follow_brackets(std::size_t i) {
        if (i == 0) return;
        const char last = code_[i - 1];
        if (last == '(' || last == '[' || last == '{') open_ += last;
        if ((last == ')' || last == ']' || last == '}') && !open_.empty()) open_.pop_back();
    }
    // The last character before i that is no space; ';' if there is none.
    char before(std::size_t i) const {
        while (i > 0 && is_space(code_[i - 1])) --i;
        return i > 0 ? code_[i - 1] : ';';
    }

    // A statement begins behind ';', '{', '}', a label, `else`, or the head of an if or a loop.
    bool begins_statement(std::size_t i) const {
        if (!is_word(code_[i]) && code_[i] != '*' && code_[i] != '+' && code_[i] != '-')
            return false;
        if ((i > 0 && !is_space(code_[i - 1])) || open_.ends_with('(')) return false;
        const char last = before(i);
        return last == ';' || last == '{' || last == '}' || behind_head(i);
    }

    // Whether what stands before i is `else`, or `if (...)` and the like.
    bool behind_head(std::size_t i) const {
        while (i > 0 && is_space(code_[i - 1])) --i;
        if (i >= 4 && code_.compare(i - 4, 4, "else") == 0) return true;
        if (i == 0 || code_[i - 1] != ')') return false;
        static const std::regex head(R"((if|if constexpr|for|while|switch) \()");
        std::size_t line = i;
        for (int depth = 0; line > 0;) {
            --line;
            if (code_[line] == ')') ++depth;
            if (code_[line] == '(' && --depth == 0) break;
        }
        const std::size_t word = code_.find_last_of("\n;{}", line);
        const std::string start = text(word == code_.npos ? 0 : word + 1, line + 1);
        return std::regex_search(start, head) && start.find_last_of('(') + 1 == start.size();
    }

    // Its end, the ';' that no bracket encloses; npos if what begins here ends otherwise.
    std::size_t end_of_statement(std::size_t i) const {
        while (i < code_.size()) {
            if (code_[i] == ';') return i;
            if (code_[i] == '}' || code_[i] == ')') return code_.npos;
            if (code_[i] == '(' || code_[i] == '[' || code_[i] == '{')
                i = behind_bracket(code_, i);
            else
                ++i;
        }
        return code_.npos;
    }

    void statement(std::size_t begin) {
        const std::size_t end = end_of_statement(begin);
        if (end == code_.npos) return;
        const std::string what = text(begin, end);
        static const std::regex other(
            R"((if|for|while|do|else|switch|case|default|using|template|struct|typedef|const|static|extern|auto|constexpr|__shared__|__device__|HD)\b[^]*)");
        static const std::regex declares(
            R"((unsigned )?[A-Za-z_][\w:]*(<[^;=]*>)?[*&]* [*&]*[A-Za-z_]\w*\s*([=({\[,][^]*)?)");
        static const std::regex ends_function(R"(return\b[^]*)"), leaves(R"((throw|delete)\b[^]*)");
        if (std::regex_match(what, other)) return;
        const bool returns = std::regex_match(what, ends_function);
        if (!returns && !std::regex_match(what, leaves) && std::regex_match(what, declares)) return;
        // A function that ends without its value does anything.
        if (returns && !behind_head(begin)) return;
        static const std::regex guard("__sync|__threadfence");
        edit(std::regex_search(what, guard) ? unguarded : deleted, begin, end - begin, "");
    }

    void binary_operator(std::size_t i) {
        std::size_t end = i;
        while (end < code_.size() && !is_space(code_[end])) ++end;
        const std::string sign = text(i, end);
        const auto [first, last] = slips().equal_range(sign);
        for (auto slip = first; slip != last; ++slip)
            edit(slip->second.kind, i, end - i, slip->second.with);
        if (sign != "-" && sign != "/" && sign != "%" && sign != "<<" && sign != ">>") return;
        const std::string_view code = code_;
        const std::string_view left = operand_before(code, i - 1);
        const std::string_view right = operand_from(code, end + 1);
        if (left.empty() || right.empty() || left == right || code_[i - 1] != ' ' ||
            code_[end] != ' ')
            return;
        edit(swapped, i - 1 - left.size(), left.size() + right.size() + end - i + 2,
             fmt::format("{} {} {}", written(right), sign, written(left)));
    }

    // A sign or a `not` before a word or a bracket; a step of a counter.
    void unary_operator(std::size_t i) {
        const auto next = [&](std::size_t n) {
            return i + n < code_.size() && (is_word(code_[i + n]) || code_[i + n] == '(');
        };
        const bool stands_first = i == 0 || is_space(code_[i - 1]) || code_[i - 1] == '(' ||
                                  code_[i - 1] == '[' || code_[i - 1] == '{';
        if (stands_first && (code_[i] == '!' || code_[i] == '-' || code_[i] == '~') && next(1))
            edit(flipped_operator, i, 1, "");
        if (code_.compare(i, 2, "++") == 0) edit(flipped_operator, i, 2, "--");
        if (code_.compare(i, 2, "--") == 0) edit(flipped_operator, i, 2, "++");
    }

    void constant(std::size_t i) {
        const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
        if (!is_digit(code_[i]) || (i > 0 && (is_word(code_[i - 1]) || code_[i - 1] == '.')))
            return;
        std::size_t end = i;
        while (end < code_.size() && is_digit(code_[end])) ++end;
        const std::string digits = text(i, end);
        if (digits.size() > 9 || (end < code_.size() && (code_[end] == 'x' || code_[end] == '\'')))
            return;
        if (i > 1 && code_[i - 1] == '-' && code_[i - 2] == 'e') return; // an exponent
        edit(off_by_one, i, digits.size(), std::to_string(std::stoi(digits) + 1));
    }

    // [i] of an array, not the length of one that is declared, nor what a lambda takes.
    void index(std::size_t i) {
        const std::size_t end = behind_bracket(code_, i);
        if (i == 0 || end == code_.npos || end == i + 2) return;
        const char last = code_[i - 1];
        if (!is_word(last) && last != ')' && last != ']') return;
        std::size_t name = i;
        while (name > 0 && is_word(code_[name - 1])) --name;
        const bool declared = name > 1 && code_[name - 1] == ' ' &&
                              (is_word(code_[name - 2]) || code_[name - 2] == '>') &&
                              !std::regex_search(text(0, name - 1), std::regex(R"(\breturn$)"));
        if (!declared) edit(shifted_index, end - 1, 0, " + 1");
    }

    // f(a, b), where a and b are operands; not where their order is the same to f.
    void two_arguments(std::size_t i) {
        static const std::regex either_way(R"(.*\b(f?min|f?max|dot|pair)$)");
        const std::string_view code = code_;
        const std::string_view first = operand_from(code, i + 1);
        const std::size_t comma = i + 1 + first.size();
        if (i == 0 || !is_word(code_[i - 1]) || first.empty() || code.substr(comma, 2) != ", ")
            return;
        const std::string_view second = operand_from(code, comma + 2);
        const std::size_t end = comma + 2 + second.size();
        if (second.empty() || first == second || end >= code.size() || code[end] != ')') return;
        if (std::regex_match(std::string(operand_before(code, i)), either_way)) return;
        edit(swapped, i + 1, end - i - 1, fmt::format("{}, {}", written(second), written(first)));
    }

    // atomicAdd(&x, n) -> ((x += n) - (n)): the value before, but not in one step.
    void plain_addition(std::size_t i) {
        const std::size_t open = i + 9, end = behind_bracket(code_, open);
        const std::size_t address = open + (code_[open + 1] == '&' ? 2 : 1);
        const std::string_view sum = operand_from(code_, address);
        const std::size_t comma = address + sum.size();
        if (end == code_.npos || sum.empty() || code_[comma] != ',') return;
        const std::string added = text(comma + 2, end - 1);
        edit(unguarded, i, end - i,
             fmt::format("(({}{} += {}) - ({}))", address == open + 1 ? "*" : "", written(sum),
                         added, added));
    }

    const std::string& written_;
    std::string code_; // without comments
    std::string open_; // brackets
    std::vector<CodeEdit> edits_;
};

} // namespace

std::string CodeEdit::apply(const std::string& code) const {
    return code.substr(0, at) + with + code.substr(at + size);
}

const std::vector<std::string>& mutation_kinds() {
    static const std::vector<std::string> kinds = {
        deleted,          unguarded,  flipped_comparison, shifted_limit,
        flipped_operator, off_by_one, shifted_index,      swapped};
    return kinds;
}

std::vector<CodeEdit> edits_of(const std::string& code) { return Finder(code).find(); }

} // namespace raylab
