// Stage 7: once the last path in the pool has ended, each path's radiance is added to the film.
//
// The kernel runs over all paths in the pool, because paths that ended early bring light too. Each
// path is added once, by the one thread that owns its pixel.
#pragma once

#include "common/task/not_implemented.h"
#include "common/wavefront/path_pool.h"
#include "common/wavefront/results.h"

namespace raylab::lab03 {

HD void accumulate_path(const PathPoolView& pool, int slot, const Results& results) {
    // Steps:
    // 1. Add the slot's radiance, one sample, to the pixel that the pool names.
    //[ task 3.1
    add_sample(results.film[pool.pixel[slot]], pool.radiance[slot]);
    //| not_implemented("3.1", "accumulate_path()");
    //]
}

} // namespace raylab::lab03
