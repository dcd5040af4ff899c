// The lecture's table of threads against bounces, as a picture: where a warp's cycles are wasted.
#pragma once

#include "common/film/ledger.h"

#include <span>
#include <string>

namespace raylab {

// A whole SVG file. At the left the paths of one warp, a column a thread and a row a bounce:
// traced, done, or wasted because another thread of the warp still traces. At the right, for all
// warps, the share of lanes at work in each bounce, from the ledger. `warp` are the records of up
// to 32 neighbouring pixels, of one sample; first_pixel is the number of the first.
std::string lanes_picture(const Ledger& ledger, std::span<const PathRecord> warp, int first_pixel);

} // namespace raylab
