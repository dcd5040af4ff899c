// From a machine instruction to the statement that it was compiled from.
#pragma once

#include "common/simt/finding.h"

#include <optional>
#include <string>

namespace raylab::simt {

// The statement of the user's that the instruction at `pc` belongs to: where that instruction was
// inlined from a header of the CPU machine or of the system, the call of that function. Nothing,
// where the program has no debug information there, the instruction is in a function of such a
// header that was not inlined (ask for its caller then), or there is no libdw.
// `pc` is an instruction that runs; of a return address give the byte before.
std::optional<SourcePlace> source_place(const void* pc);

// The name of the function with this instruction, as C++ writes it; empty if not known.
std::string function_name(const void* pc);

} // namespace raylab::simt
