// Accumulation: the unaccumulated colours join the film, once the last path of the batch has ended.
//
// All paths of the batch, not those that are alive: a path that ended early brings its light too.
// Each is added once, by the one thread that owns its pixel now.
#pragma once

#include "common/wavefront/path_pool.h"
#include "common/wavefront/results.h"

namespace raylab {

HD void accumulate_path(const PathPoolView& pool, int slot, const Results& results) {
    add_sample(results.film[pool.pixel[slot]], pool.radiance[slot]);
}

} // namespace raylab
