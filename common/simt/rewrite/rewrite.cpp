// The rewriter; see rewrite.h. It collects edits, places where text is replaced, and leaves every
// character between them alone.
#include "common/simt/rewrite/rewrite.h"

#include "common/simt/rewrite/conditions.h"
#include "common/simt/rewrite/foreign.h"
#include "common/simt/rewrite/source.h"

#include <algorithm>
#include <vector>

namespace raylab::simt {

namespace {

struct Edit {
    size_t begin, length;
    std::string text;
};

class Rewriter : Source {
  public:
    Rewriter(std::string_view source, const std::string& name, bool foreign)
        : Source(source, name), foreign_(foreign), conditions_(source, tokens_) {}

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
    Edit replace(size_t first, size_t last, const std::string& text) const {
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

    bool foreign_;
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
