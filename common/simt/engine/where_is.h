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

// The variable that lies at, or ends before, an address: one of the program's, as __shared__ arrays
// are under AddressSanitizer. Nothing for what is on a stack or a heap.
struct Variable {
    std::string name;
    size_t offset = 0, bytes = 0; // of the address in it, and its size
};
std::optional<Variable> variable_at(const void* address);

// The name of the function with this instruction, as C++ writes it; empty if not known.
std::string function_name(const void* pc);

} // namespace raylab::simt
