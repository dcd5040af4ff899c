// What was running when a signal came, in words and lines.
#pragma once

#include "common/simt/engine/faults.h"
#include "common/simt/finding.h"

#include <csignal>
#include <string>

namespace raylab::simt {

// For a handler of signals: nothing is allocated.
Fault interrupted(int signal, siginfo_t* information, void* context);

// The caller and its callers, the innermost first; in front of them `pc`, if it is known.
Fault callers_of(const void* pc);

// The innermost statement of the user's; an empty place if there is none that is known.
SourcePlace user_place(const Fault& fault);

// "integer division by zero"
std::string signal_in_words(const Fault& fault);

} // namespace raylab::simt
