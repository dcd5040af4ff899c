// Whitted's branches in a wavefront.
//
// Glass sends two rays on. To push both into the pool would be the obvious way, and would lose the
// order in which a pixel's branches are added up, and with it the last bits. So a path keeps its
// slot and traces its tree one branch a bounce, newest first, as the loop of lab 02 does; the
// branches that wait lie in a stack of its own. All pixels' trees are traced side by side, and one
// deep tree keeps a launch alive for itself alone: compaction pays here more than anywhere.
#pragma once

#include "common/wavefront/path_pool.h"

namespace raylab {

HD void push_branch(const PathPoolView& pool, int slot, const PendingRay& ray) {
    const int k = pool.pending[slot]++;
    pool.stack[static_cast<std::int64_t>(k) * pool.capacity + slot] = ray;
}

// The newest branch becomes the slot's ray; without one the path ends.
HD void next_branch(const PathPoolView& pool, int slot) {
    if (pool.pending[slot] == 0) return end_path(pool, slot, PathEnd::absorbed);
    const int k = --pool.pending[slot];
    const PendingRay ray = pool.stack[static_cast<std::int64_t>(k) * pool.capacity + slot];
    pool.origin[slot] = ray.origin;
    pool.direction[slot] = ray.direction;
    pool.throughput[slot] = ray.throughput;
    pool.bounce[slot] = ray.depth;
    pool.node[slot] = ray.node;
}

} // namespace raylab
