// C++ cut into tokens, just finely enough to find `k<<<...>>>(...)`.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace raylab::simt {

struct Token {
    enum class Kind { word, number, text, mark } kind; // text: a string or character literal
    std::string_view spelling;                         // marks: one character, or `::` or `->`
    size_t begin;                                      // offset in the source
    int line;                                          // from 1
    size_t end() const { return begin + spelling.size(); }
};

// The tokens of a source. Comments, #include, #error and #pragma lines are left out; the lines of
// other directives count, for macros may launch kernels. Of each #include, what it names goes to
// `includes`: "x.h" or <x.h>, with its quotes.
std::vector<Token> tokenize(std::string_view source, std::vector<Token>* includes = nullptr);

} // namespace raylab::simt
