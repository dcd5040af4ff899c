// Cutting C++ into tokens; see lexer.h.
#include "common/simt/rewrite/lexer.h"

#include <algorithm>
#include <cctype>
#include <utility>

namespace raylab::simt {

namespace {

bool starts_word(char c) { return std::isalpha((unsigned char)c) || c == '_' || (c & 0x80); }
bool in_word(char c) { return starts_word(c) || std::isdigit((unsigned char)c); }

class Lexer {
  public:
    Lexer(std::string_view source, std::vector<Token>* includes)
        : source_(source), includes_(includes) {}

    std::vector<Token> run() {
        while (at_ < source_.size()) step();
        return std::move(tokens_);
    }

  private:
    char look(size_t ahead = 0) const {
        return at_ + ahead < source_.size() ? source_[at_ + ahead] : '\0';
    }
    bool sees(std::string_view text) const { return source_.substr(at_, text.size()) == text; }

    void step() {
        char c = look();
        line_start_ |= c == '\n';
        if (std::isspace((unsigned char)c)) return skip(1);
        if (c == '\\' && (look(1) == '\n' || look(1) == '\r')) return skip(2);
        if (sees("//")) return skip_line();
        if (sees("/*")) return skip_past("*/", 2);
        bool first = std::exchange(line_start_, false);
        if (c == '#' && first && skip_directive()) return;
        if (starts_word(c)) return word();
        if (std::isdigit((unsigned char)c) || (c == '.' && std::isdigit((unsigned char)look(1))))
            return number();
        if (c == '"' || c == '\'') return literal(at_);
        add(Token::Kind::mark, at_, sees("::") || sees("->") ? 2 : 1);
    }

    void word() {
        size_t begin = at_, length = 0;
        while (in_word(look(length))) ++length;
        std::string_view name = source_.substr(begin, length);
        if (look(length) == '"' && name.back() == 'R' && name.size() <= 3) return raw_string();
        bool prefix = name == "u8" || name == "u" || name == "U" || name == "L";
        if (prefix && (look(length) == '"' || look(length) == '\'')) {
            at_ += length;
            return literal(begin);
        }
        add(Token::Kind::word, begin, length);
    }

    // Also 1'000'000, 0x1p-3f and 1e+5: their quotes and signs belong to them.
    void number() {
        size_t length = 1;
        while (in_word(look(length)) || look(length) == '.' ||
               (look(length) == '\'' && in_word(look(length + 1))) ||
               ((look(length) == '+' || look(length) == '-') &&
                std::string_view("eEpP").find(look(length - 1)) != std::string_view::npos))
            ++length;
        add(Token::Kind::number, at_, length);
    }

    // A string or character literal; it ends with its line at the latest.
    void literal(size_t begin) {
        char quote = look();
        size_t length = 1;
        while (at_ + length < source_.size() && look(length) != quote && look(length) != '\n')
            length += look(length) == '\\' ? 2 : 1;
        if (look(length) == quote) ++length;
        add(Token::Kind::text, begin, std::min(at_ + length, source_.size()) - begin);
    }

    // R"delimiter( ... )delimiter"
    void raw_string() {
        size_t open = source_.find('"', at_), paren = source_.find('(', open);
        size_t close = std::string_view::npos;
        if (paren != std::string_view::npos) {
            std::string end = ")" + std::string(source_.substr(open + 1, paren - open - 1)) + "\"";
            close = source_.find(end, paren);
            if (close != std::string_view::npos) close += end.size();
        }
        add(Token::Kind::text, at_, std::min(close, source_.size()) - at_);
    }

    bool skip_directive() {
        size_t length = 1;
        while (look(length) == ' ' || look(length) == '\t') ++length;
        for (std::string_view name : {"include", "error", "warning", "pragma", "line"})
            if (source_.substr(at_ + length, name.size()) == name) {
                if (name == "include") note_include(at_ + length + name.size());
                skip_line();
                return true;
            }
        return false;
    }

    void note_include(size_t from) {
        size_t begin = source_.find_first_not_of(" \t", from);
        if (!includes_ || begin == std::string_view::npos) return;
        char last = source_[begin] == '<' ? '>' : source_[begin] == '"' ? '"' : '\n';
        size_t end = source_.find(last, begin + 1);
        if (last == '\n' || end == std::string_view::npos) return; // a macro
        includes_->push_back(
            {Token::Kind::text, source_.substr(begin, end + 1 - begin), begin, line_});
    }

    void skip_line() {
        while (at_ < source_.size() && look() != '\n')
            skip(look() == '\\' && look(1) == '\n' ? 2 : 1);
    }
    void skip_past(std::string_view end, size_t from) {
        size_t found = source_.find(end, at_ + from);
        skip((found == std::string_view::npos ? source_.size() : found + end.size()) - at_);
    }

    void skip(size_t length) { advance(std::min(at_ + length, source_.size())); }

    void advance(size_t end) {
        line_ += int(std::count(source_.begin() + at_, source_.begin() + end, '\n'));
        at_ = end;
    }

    void add(Token::Kind kind, size_t begin, size_t length) {
        tokens_.push_back({kind, source_.substr(begin, length), begin, line_});
        advance(begin + length);
    }

    std::string_view source_;
    std::vector<Token>* includes_;
    std::vector<Token> tokens_;
    size_t at_ = 0;
    int line_ = 1;
    bool line_start_ = true;
};

} // namespace

std::vector<Token> tokenize(std::string_view source, std::vector<Token>* includes) {
    return Lexer(source, includes).run();
}

} // namespace raylab::simt
