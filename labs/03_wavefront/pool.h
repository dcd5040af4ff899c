// The ray pool of this lab; common/wavefront/path_pool.h says why it lies as it does.
#pragma once

#include "common/wavefront/path_pool.h"

namespace raylab::lab03 {

// PoolView::kind of a slot whose ray hit nothing: nothing to shade.
constexpr std::uint8_t no_kind = 7;

struct PoolView : PathPoolView {
    using PathPoolView::PathPoolView;

    std::uint8_t* kind = deal(); // of the material that was hit; no_kind: nothing to shade
};

constexpr std::size_t path_bytes = PoolView(0).bytes_per_slot;
static_assert(path_bytes == 130, "the handout and --memory-budget promise 130 bytes a path");

} // namespace raylab::lab03
