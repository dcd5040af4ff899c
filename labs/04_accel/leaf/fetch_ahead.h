// Loading memory before it is known whether it will be read.
#pragma once

#include "common/math/hd.h"

#include <cstddef>

namespace raylab::lab04 {

// Tells a CPU to load *what into its caches, and does not wait for it. `what` may point past the
// end of an array. On a GPU it does nothing: while one warp waits, others run.
template <class T> HD_HOT void fetch_ahead([[maybe_unused]] const T* what) {
#if !defined(__CUDA_ARCH__)
    for (std::size_t byte = 0; byte < sizeof(T); byte += 64)
        __builtin_prefetch(reinterpret_cast<const char*>(what) + byte);
#endif
}

} // namespace raylab::lab04
