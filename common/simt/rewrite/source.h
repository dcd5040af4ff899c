// A source in tokens, and the ways about in it: to the other bracket, and to a kernel's first
// token.
#pragma once

#include "common/simt/rewrite/lexer.h"
#include "common/simt/rewrite/rewrite.h"

#include <string>
#include <vector>

namespace raylab::simt {

inline bool opens(const Token& t) {
    return t.spelling == "(" || t.spelling == "[" || t.spelling == "{";
}
inline bool closes(const Token& t) {
    return t.spelling == ")" || t.spelling == "]" || t.spelling == "}";
}

class Source {
  protected:
    Source(std::string_view source, const std::string& name)
        : source_(source), name_(name), tokens_(tokenize(source, &includes_)) {}

    bool is(size_t i, std::string_view spelling) const {
        return i < tokens_.size() && tokens_[i].kind != Token::Kind::text &&
               tokens_[i].spelling == spelling;
    }

    [[noreturn]] void fail(const Token& token, const std::string& what) const {
        throw RewriteError(name_ + ":" + std::to_string(token.line) + ": error: " + what);
    }
    [[noreturn]] void fail(size_t i, const std::string& what) const { fail(tokens_[i], what); }

    // Three marks in a row. Some formatters, and therefore some programs, write `<< <`, which has
    // no other meaning in C++.
    bool triple(size_t i, std::string_view mark) const {
        return is(i, mark) && is(i + 1, mark) && is(i + 2, mark) &&
               tokens_[i + 1].begin == tokens_[i].begin + 1;
    }

    // The first token of the expression that ends before `end`: names joined by :: . and ->, with
    // template arguments, calls, indices, or something in parentheses.
    size_t kernel_begin(size_t end) const {
        size_t i = end;
        for (;;) {
            size_t last = i - 1;
            if (is(last, ")") || is(last, "]")) {
                i = matching(last);
                bool operand_before =
                    i > 0 && (is_name(i - 1) || is(i - 1, "]") || is(i - 1, ">") ||
                              (is(i - 1, ")") && !ends_condition(i - 1)));
                if (!operand_before) return i; // (expression)<<<
                continue;                      // f(...)<<< or table[...]<<<
            }
            if (is(last, ">")) last = template_arguments(last) - 1;
            if (last >= tokens_.size() || !is_name(last))
                fail(end, "there is no kernel before <<<");
            i = last;
            if (i > 0 && is(i - 1, "template")) --i;
            if (i == 0 || !(is(i - 1, "::") || is(i - 1, ".") || is(i - 1, "->"))) return i;
            --i;
            bool more =
                i > 0 && (is_name(i - 1) || is(i - 1, ">") || is(i - 1, ")") || is(i - 1, "]"));
            if (!more) return i; // ::k<<<
        }
    }

    bool is_name(size_t i) const {
        return tokens_[i].kind == Token::Kind::word && !is(i, "return") && !is(i, "else") &&
               !is(i, "do") && !is(i, "case") && !is(i, "co_return");
    }

    // Whether this `)` closes the condition of an if, a loop or a switch.
    bool ends_condition(size_t close) const {
        size_t open = matching(close);
        if (open > 0 && is(open - 1, "constexpr")) --open;
        return open > 0 && (is(open - 1, "if") || is(open - 1, "while") || is(open - 1, "for") ||
                            is(open - 1, "switch"));
    }

    // The bracket that the one at `close` closes.
    size_t matching(size_t close) const {
        size_t depth = 0;
        for (size_t i = close;; --i) {
            if (closes(tokens_[i])) ++depth;
            if (opens(tokens_[i]) && --depth == 0) return i;
            if (i == 0) fail(close, "unbalanced brackets before <<<");
        }
    }

    // The `<` that opens the template arguments ended by the `>` at `close`.
    size_t template_arguments(size_t close) const {
        size_t depth = 0;
        for (size_t i = close;; --i) {
            if (closes(tokens_[i]))
                i = matching(i);
            else if (is(i, ">"))
                ++depth;
            else if (is(i, "<") && --depth == 0)
                return i;
            if (i == 0) fail(close, "unbalanced template arguments before <<<");
        }
    }

    size_t close_of(size_t open) const {
        size_t depth = 0;
        for (size_t i = open; i < tokens_.size(); ++i) {
            if (opens(tokens_[i])) ++depth;
            if (closes(tokens_[i]) && --depth == 0) return i;
        }
        fail(open, "unbalanced brackets");
    }

    std::string text(size_t first, size_t end) const {
        std::string all;
        for (size_t i = first; i < end; ++i) all += tokens_[i].spelling;
        return all;
    }

    std::string_view source_;
    std::string name_;
    std::vector<Token> includes_, tokens_;
};

} // namespace raylab::simt
