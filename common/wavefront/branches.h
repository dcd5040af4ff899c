// Whitted's branches in a wavefront.
//
// Glass sends two rays on. If both were pushed into the pool, a pixel's branches would be added up
// in another order, and the last bits of the sum would change. So a path keeps its slot and traces
// one branch of its tree a bounce, the newest first, as the loop of lab 02 does. The branches that
// wait lie in a stack that belongs to the slot. The trees of all pixels are traced side by side.
// The deepest tree decides how many launches there are, so compaction saves most here.
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
