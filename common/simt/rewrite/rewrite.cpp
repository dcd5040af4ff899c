// The rewriter; see rewrite.h. It collects edits, places where text is replaced, and leaves every
// character between them alone.
#include "common/simt/rewrite/rewrite.h"

#include "common/simt/rewrite/lexer.h"

#include <algorithm>
#include <vector>

namespace raylab::simt {

namespace {

struct Edit {
    size_t begin, length;
    std::string text;
};

bool opens(const Token& t) { return t.spelling == "(" || t.spelling == "[" || t.spelling == "{"; }
bool closes(const Token& t) { return t.spelling == ")" || t.spelling == "]" || t.spelling == "}"; }

class Rewriter {
  public:
    Rewriter(std::string_view source, const std::string& name)
        : source_(source), name_(name), tokens_(tokenize(source)) {}

    std::string run() {
        for (size_t i = 0; i < tokens_.size(); ++i) {
            track_scope(i);
            if (is_launch(i)) launch(i);
            if (is(i, "extern")) shared_memory(i);
        }
        std::stable_sort(edits_.begin(), edits_.end(),
                         [](const Edit& a, const Edit& b) { return a.begin < b.begin; });
        std::string out = "#line 1 \"" + name_ + "\"\n";
        size_t copied = 0;
        for (const Edit& edit : edits_) {
            out += source_.substr(copied, edit.begin - copied);
            out += edit.text;
            copied = edit.begin + edit.length;
        }
        out += source_.substr(copied);
        return out;
    }

  private:
    bool is(size_t i, std::string_view spelling) const {
        return i < tokens_.size() && tokens_[i].kind != Token::Kind::text &&
               tokens_[i].spelling == spelling;
    }

    [[noreturn]] void fail(size_t i, const std::string& what) const {
        throw RewriteError(name_ + ":" + std::to_string(tokens_[i].line) + ": error: " + what);
    }

    // Three marks in a row, with nothing in between.
    bool triple(size_t i, std::string_view mark) const {
        return is(i, mark) && is(i + 1, mark) && is(i + 2, mark) &&
               tokens_[i + 2].begin == tokens_[i].begin + 2;
    }

    // `operator<<<T>` is the one place where C++ itself has `<<<`.
    bool is_launch(size_t i) const {
        return triple(i, "<") && i > 0 && !is(i - 1, "operator") && !is(i - 1, "<");
    }

    // k <<< configuration >>> (
    void launch(size_t open) {
        size_t first = kernel_begin(open);
        size_t depth = 0, close = open + 3;
        for (;; ++close) {
            if (close >= tokens_.size()) fail(open, "this <<< has no >>>");
            if (depth == 0 && triple(close, ">") && is(close + 3, "(")) break;
            if (opens(tokens_[close])) ++depth;
            if (closes(tokens_[close]) && depth-- == 0) fail(open, "this <<< has no >>>(");
        }
        edits_.push_back({tokens_[first].begin, 0, "::raylab::simt::launcher(RAYLAB_KERNEL("});
        edits_.push_back({tokens_[open].begin, 3, "), "});
        edits_.push_back({tokens_[close].begin, 3, ")"});
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

    // extern __shared__ [alignment] T name[][N];
    void shared_memory(size_t begin) {
        size_t end = begin, name = 0, bracket = 0;
        bool shared = false;
        while (end < tokens_.size() && !is(end, ";") && !is(end, "{") && !is(end, "=")) {
            shared |= is(end, "__shared__");
            if (!bracket && is(end, "[") && tokens_[end - 1].kind == Token::Kind::word) {
                bracket = end;
                name = end - 1;
            }
            ++end;
        }
        if (!shared || !bracket || !is(bracket + 1, "]") || !is(end, ";")) return;
        if (at_namespace_scope())
            fail(begin, "extern __shared__ stands outside of a function; the CPU machine wants it "
                        "inside the kernel that uses it");
        std::string type;
        for (size_t i = begin + 1; i < name; ++i) {
            if (is(i, "__shared__")) continue;
            if (is(i, "__align__") || is(i, "alignas") || is(i, "__attribute__")) {
                i = close_of(i + 1);
                continue;
            }
            type += (type.empty() ? "" : " ") + std::string(tokens_[i].spelling);
        }
        std::string variable(tokens_[name].spelling), inner = text(bracket + 2, end);
        std::string pointer =
            inner.empty() ? type + "* " + variable : type + " (*" + variable + ")" + inner;
        size_t from = tokens_[begin].begin, length = tokens_[end].begin - from;
        size_t lines = size_t(
            std::count(source_.begin() + long(from), source_.begin() + long(from + length), '\n'));
        edits_.push_back({from, length,
                          pointer + " = ::raylab::simt::dynamic_shared<" + type + inner + ">()" +
                              std::string(lines, '\n')});
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

    // Scopes: namespaces and extern "C" on one side, everything else on the other.
    void track_scope(size_t i) {
        if (is(i, "}") && !scopes_.empty()) scopes_.pop_back();
        if (!is(i, "{")) return;
        size_t before = i;
        while (before > 0 &&
               (tokens_[before - 1].kind == Token::Kind::word || is(before - 1, "::")) &&
               !is(before - 1, "namespace"))
            --before;
        bool name_space = before > 0 && is(before - 1, "namespace");
        bool linkage = i > 1 && tokens_[i - 1].kind == Token::Kind::text && is(i - 2, "extern");
        scopes_.push_back(name_space || linkage);
    }
    bool at_namespace_scope() const {
        return std::find(scopes_.begin(), scopes_.end(), false) == scopes_.end();
    }

    std::string_view source_;
    std::string name_;
    std::vector<Token> tokens_;
    std::vector<Edit> edits_;
    std::vector<bool> scopes_;
};

} // namespace

std::string rewrite(std::string_view source, const std::string& name) {
    return Rewriter(source, name).run();
}

} // namespace raylab::simt
