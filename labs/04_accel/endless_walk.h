// What is said of a walk that does not end.
//
// Every step of a walk must bring it nearer to its end: deeper, or on to what is still unvisited.
// One mistake in a link and it goes round in circles, on a GPU for ever, with nothing on the
// screen. So walks count their nodes (leaf/query.h, most_steps), and the first that has no end
// stops the render.
#pragma once

#include "common/film/ledger.h"
#include "labs/04_accel/structure.h"

#include <stdexcept>

namespace raylab::lab04 {

struct EndlessWalk : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// Names the ray, its pixel of a film so wide, structure and walk, and what to look for.
EndlessWalk endless_walk(const EndlessRay& ray, int width, std::uint32_t sample,
                         const StructureFacts& structure);

} // namespace raylab::lab04
