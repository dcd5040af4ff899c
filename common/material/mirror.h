// A perfect mirror: all light from the mirrored direction, a delta lobe. PBR4e 9.3.1.
#pragma once

#include "common/material/bsdf_sample.h"

namespace raylab {

// wo above the surface. f cos / pdf of a delta lobe is its reflectance: both deltas cancel.
HD BsdfSample sample_mirror(Vec3 reflectance, Vec3 wo) {
    return {Vec3(-wo.x, -wo.y, wo.z), reflectance, 0, true, true};
}

} // namespace raylab
