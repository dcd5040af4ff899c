// Signals that a kernel's own mistake raises: a null or wild pointer, a stack that is full, an
// integer division by zero, abort(). The thread that is running is known, so it can be named, and
// the line.
#pragma once

#include <array>
#include <cstddef>

namespace raylab::simt {

// What a signal told about the instruction that it interrupted.
struct Fault {
    int signal = 0;                // 0: none
    int code = 0;                  // si_code
    const void* address = nullptr; // that was touched
    bool write = false;            // rather than read; false where the processor does not tell
    std::array<const void*, 24> frames{}; // instructions, the innermost first, then its callers
    size_t frame_count = 0;
};

// To be called by every operating system thread before it runs blocks. Installs the handlers, once,
// and gives the thread a stack for them: its own may be full.
void expect_faults();

} // namespace raylab::simt
