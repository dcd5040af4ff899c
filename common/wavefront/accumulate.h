// Accumulation: once the last path in the pool has ended, the radiance of each path is added to
// the film.
//
// The kernel runs over all paths in the pool, because paths that ended early bring light too. Each
// path is added once, by the one thread that owns its pixel.
#pragma once

#include "common/wavefront/path_pool.h"
#include "common/wavefront/results.h"

namespace raylab {

HD void accumulate_path(const PathPoolView& pool, int slot, const Results& results) {
    add_sample(results.film[pool.pixel[slot]], pool.radiance[slot]);
}

} // namespace raylab
