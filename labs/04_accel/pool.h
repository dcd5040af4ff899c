// The ray pool of lab 03, with room for what walks find.
//
// A path's rays are traced in two steps, by a walk through the triangles and by a test of the other
// shapes, so the hit is passed on through the pool from the one to the other: PathPoolView::hit has
// the closest triangle first, then the closest shape of any kind.
#pragma once

#include "common/wavefront/path_pool.h"

namespace raylab::lab04 {

struct PoolView : PathPoolView {
    using PathPoolView::PathPoolView;

    std::uint8_t* blocked = deal();    // the shadow ray, by a triangle
    Vec3* direct = deal(branches > 0); // Whitted's light that its shadow rays have found here
};

constexpr std::size_t path_bytes = PoolView(0).bytes_per_slot;
static_assert(path_bytes == 130, "as in lab 03");

} // namespace raylab::lab04
