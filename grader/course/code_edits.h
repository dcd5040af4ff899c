// Small faults in C++: the places of a text where a slip of the hand could be, and the slip.
//
// The text is read as words and signs, not as C++. It counts on our format: binary operators stand
// between spaces, and neither templates, pointers nor references do. A few edits do not compile.
#pragma once

#include <string>
#include <vector>

namespace raylab {

struct CodeEdit {
    std::string kind; // of mutation_kinds()
    std::size_t at, size;
    std::string with; // in place of the `size` characters from `at` on

    std::string apply(const std::string& code) const;
};

// "statement deleted", "barrier, atomic or fence removed", "comparison flipped", "limit shifted",
// "operator flipped", "constant off by one", "index shifted", "operands swapped".
const std::vector<std::string>& mutation_kinds();

// All edits of a piece of code, in the order of their places. The code is whole statements; what is
// in comments, literals of text and lines of the preprocessor stays.
std::vector<CodeEdit> edits_of(const std::string& code);

} // namespace raylab
