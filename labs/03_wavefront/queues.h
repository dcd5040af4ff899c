// Queues of slots: one stage fills them, a later stage works on what is in them.
#pragma once

#include "common/material/material.h"

namespace raylab::lab03 {

constexpr int material_kinds = static_cast<int>(MaterialKind::rough_dielectric) + 1;

// The numbers that the host reads between two stages.
struct Counters {
    int kind[material_kinds]; // paths in each kind's queue
    int shadow_rays;
    int alive;      // paths, in a list that was not compacted
    int busy_warps; // warps of that list with a path alive
};

struct Queues {
    int* kind[material_kinds]; // slots by material; null: that kind has no queue
    int* shadow_rays;          // slots whose shadow ray is on its way
    Counters* counters;
};

} // namespace raylab::lab03
