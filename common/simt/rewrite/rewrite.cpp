// The rewriter; see rewrite.h. It collects edits, places where text is replaced, and leaves every
// character between them alone.
#include "common/simt/rewrite/rewrite.h"

#include "common/simt/rewrite/conditions.h"
#include "common/simt/rewrite/foreign.h"
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
    Rewriter(std::string_view source, const std::string& name, bool foreign)
        : source_(source), name_(name), foreign_(foreign), tokens_(tokenize(source, &includes_)),
          conditions_(source, tokens_) {}

    std::string run() {
        for (size_t i = 0; i < tokens_.size(); ++i) {
            track_scope(i);
            if (is_launch(i)) launch(i);
            if (is(i, "extern")) shared_memory(i);
            if (foreign_) foreign(i);
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

    void rewrite_includes(const std::function<Include(std::string_view)>& include) {
        for (const Token& token : includes_) {
            Include become = include(token.spelling);
            if (!become.refusal.empty() && !conditions_.may_be_skipped(token.begin))
                fail(token, become.refusal);
            if (!become.refusal.empty()) {
                size_t line = source_.rfind('#', token.begin);
                edits_.push_back(
                    {line, token.end() - line, "#pragma GCC error \"" + become.refusal + "\""});
            } else if (!become.replacement.empty()) {
                edits_.push_back({token.begin, token.spelling.size(), become.replacement});
            }
        }
    }

  private:
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
    Edit replace(size_t first, size_t last, std::string text) const {
        size_t begin = tokens_[first].begin, length = tokens_[last].end() - begin;
        auto lines =
            std::count(source_.begin() + long(begin), source_.begin() + long(begin + length), '\n');
        return {begin, length, text + std::string(size_t(lines), '\n')};
    }

    // The program is refused, or, if the compiler may skip this place, told so by the compiler.
    void refuse(size_t i, const std::string& what) {
        if (!conditions_.may_be_skipped(tokens_[i].begin)) fail(i, what);
        edits_.push_back({tokens_[i].begin, 0, "_Pragma(\"GCC error \\\"" + what + "\\\"\") "});
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
        if (foreign_ && in_kernel())
            refuse(first, "a kernel launches a kernel: the CPU machine has no dynamic parallelism");
        edits_.push_back({tokens_[first].begin, 0, "::raylab::simt::launcher(RAYLAB_KERNEL("});
        edits_.push_back(replace(open, open + 2, "), "));
        edits_.push_back(replace(close, close + 2, ")"));
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

    // extern __shared__ [alignment] T name[][N]; or T name;
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
        if (!shared || !is(end, ";") || end < begin + 3) return;
        if (!bracket) name = end - 1;
        if (tokens_[name].kind != Token::Kind::word) return;
        if (at_namespace_scope() && !(foreign_ && bracket))
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
        std::string variable(tokens_[name].spelling);
        std::string inner = bracket ? text(close_of(bracket) + 1, end) : std::string();
        if (inner.find(',') != std::string::npos)
            fail(begin, "two arrays in one extern __shared__: they are one memory, write one");
        std::string memory = "::raylab::simt::dynamic_shared<" + type + inner + ">()";
        std::string pointer =
            inner.empty() ? type + "* " + variable : type + " (*" + variable + ")" + inner;
        std::string declaration =
            bracket ? pointer + " = " + memory : type + "& " + variable + " = *" + memory;
        if (at_namespace_scope())
            declaration = "[[maybe_unused]] static constexpr ::raylab::simt::DynamicShared<" +
                          type + inner + "> " + variable + "{}";
        edits_.push_back(replace(begin, end, declaration + ";"));
    }

    // What rewrite_foreign() does besides.
    void foreign(size_t i) {
        if (is(i, "asm") || is(i, "__asm__") || is(i, "__asm")) inline_assembly(i);
        if (is_inline(i)) {
            for (size_t j = i; j-- > 0 && tokens_[j].kind == Token::Kind::word;)
                if (is_inline(j)) {
                    edits_.push_back(replace(i, i, ""));
                    break;
                }
        }
        if (is(i, "texture")) {
            if (i > 0 && (is(i - 1, "class") || is(i - 1, "struct"))) own_texture_ = true;
            if (is(i + 1, "<") && !own_texture_)
                edits_.push_back(replace(i, i, "::raylab::simt::TextureReference"));
        }
        if (is(i, "__noinline__") && (i == 0 || (!is(i - 1, "(") && !is(i - 1, ","))))
            edits_.push_back(replace(i, i, "__attribute__((noinline))"));
        if ((is(i, "cudaLaunchKernel") || is(i, "cudaLaunchCooperativeKernel")) && is(i + 1, "("))
            strip_cast(i + 2);
    }
    bool is_inline(size_t i) const {
        return is(i, "inline") || is(i, "__inline__") || is(i, "__inline") ||
               is(i, "__forceinline__");
    }

    void inline_assembly(size_t begin) {
        size_t open = begin + 1;
        while (is(open, "volatile") || is(open, "__volatile__") || is(open, "goto")) ++open;
        if (!is(open, "(")) return;
        size_t close = close_of(open), from = tokens_[open].begin;
        if (!is_ptx(source_.substr(from, tokens_[close].begin - from))) return;
        refuse(begin, "inline PTX runs on a GPU alone: the CPU machine does not know it");
        edits_.push_back(replace(begin, close, "((void)0)"));
    }

    // (void*)k, (const void*)k or reinterpret_cast<void*>(k).
    void strip_cast(size_t i) {
        size_t type = is(i, "reinterpret_cast") && is(i + 1, "<") ? i + 2 : i + 1;
        if (type == i + 1 && !is(i, "(")) return;
        size_t star = is(type, "const") ? type + 2 : type + 1;
        if (is(star - 1, "void") && is(star, "*") && (is(star + 1, ")") || is(star + 1, ">")))
            edits_.push_back(replace(i, star + 1, ""));
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
        if (at_namespace_scope()) kernel_ = !name_space && !linkage && is_device_code(i);
        scopes_.push_back(name_space || linkage);
    }
    // Whether a function that begins here is marked as the device's alone.
    bool is_device_code(size_t brace) const {
        bool device = false;
        for (size_t i = brace; i-- > 0 && !is(i, ";") && !is(i, "{") && !is(i, "}");) {
            device |= is(i, "__global__") || is(i, "__device__");
            if (is(i, "__host__")) return false;
        }
        return device;
    }
    bool in_kernel() const { return kernel_ && !at_namespace_scope(); }
    bool at_namespace_scope() const {
        return std::find(scopes_.begin(), scopes_.end(), false) == scopes_.end();
    }

    std::string_view source_;
    std::string name_;
    bool foreign_;
    std::vector<Token> includes_, tokens_;
    Conditions conditions_;
    std::vector<Edit> edits_;
    std::vector<bool> scopes_;
    bool own_texture_ = false;
    bool kernel_ = false; // of the function around, whether it runs on the device alone
};

} // namespace

std::string rewrite(std::string_view source, const std::string& name) {
    return Rewriter(source, name, false).run();
}

std::string rewrite_foreign(std::string_view source, const std::string& name,
                            const std::function<Include(std::string_view)>& include) {
    Rewriter rewriter(source, name, true);
    rewriter.rewrite_includes(include);
    return rewriter.run();
}

} // namespace raylab::simt
