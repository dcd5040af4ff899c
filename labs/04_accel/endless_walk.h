// The message about a walk that does not end.
//
// Every step must bring a walk nearer to its end: deeper, or on to what is not visited yet. With
// one mistake in a link it goes round in circles, on a GPU for ever and without a message. So walks
// count their nodes (leaf/query.h, most_steps), and the first walk without an end stops the render.
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
