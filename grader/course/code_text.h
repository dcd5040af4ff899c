// Reading C++ as a text: what is a comment, where a bracket closes, where an operand begins.
#pragma once

#include <string>
#include <string_view>

namespace raylab {

bool is_word(char c); // of a name or a number

// The same code with spaces in place of comments, literals of text and lines of the preprocessor.
std::string without_comments(std::string code);

// From a bracket `(`, `[` or `{` to the place behind the one that closes it; npos if none does.
std::size_t behind_bracket(std::string_view code, std::size_t open);

// The operand that ends before `end` or begins at `begin`: a name or a number with its calls,
// indices and members, "scene.shapes[i].t", without a sign. Empty if there is no such operand.
std::string_view operand_before(std::string_view code, std::size_t end);
std::string_view operand_from(std::string_view code, std::size_t begin);

} // namespace raylab
