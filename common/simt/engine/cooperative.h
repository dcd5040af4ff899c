// A cooperative launch: all blocks run at the same time, and may wait for each other.
#pragma once

#include "common/simt/engine/workers.h"

namespace raylab::simt {

// Blocks share static __shared__ variables in AddressSanitizer's build (qualifiers.h), so there
// only one can run at a time.
#if defined(RAYLAB_CHECK_ADDRESS)
inline constexpr uint64_t most_cooperative_blocks = 1;
#else
inline constexpr uint64_t most_cooperative_blocks = 256;
#endif

// Runs every block on an operating system thread of its own. Returns a fault, or nothing.
Workers::KernelFault run_cooperative(const Work& work, const Options& options);

} // namespace raylab::simt
