// Which parts of a source the compiler may never come to: those under an #if, and macros.
#pragma once

#include "common/simt/rewrite/lexer.h"

namespace raylab::simt {

class Conditions {
  public:
    Conditions(std::string_view source, const std::vector<Token>& tokens);

    // An include guard around the whole file does not count.
    bool may_be_skipped(size_t offset) const;

  private:
    struct Part {
        size_t begin, end;
    };
    std::vector<Part> parts_;
};

} // namespace raylab::simt
