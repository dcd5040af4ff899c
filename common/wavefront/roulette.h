// Russian roulette, as in lab 02.
#pragma once

#include "common/math/vec.h"

namespace raylab {

// From the second surface on, a path survives with probability q. The throughput of a survivor is
// divided by q, so the mean of the radiance stays the same.
HD bool survives_roulette(Vec3& throughput, int bounce, float u) {
    if (bounce < 1) return true;
    const float q = glm::min(1.0f, 2.5f * max_component(throughput));
    if (u >= q) return false;
    throughput /= q;
    return true;
}

} // namespace raylab
