// Findings in words, as the terminal shows them.
#pragma once

#include "common/simt/finding.h"

#include <string>

namespace raylab::simt {

// "f.cu:8:5"
std::string in_words(const SourcePlace& place);

// "kernel k, block (0,0,0), thread (3,0,0)"; what is not known is left out.
std::string in_words(const Actor& actor);

// "other end: f.cu:4:7, write, by kernel k, ..."; finding.other is there.
std::string other_end(const Finding& finding);

// All of it, each line with its line break.
std::string to_text(const Finding& finding);

} // namespace raylab::simt
