// Puts a direction on the side of the face that fits its side of the shading normal.
#pragma once

#include "common/trace/surface.h"

namespace raylab {

// w's mirror image in the plane of the face: w - 2 (w.ng) ng. World.
HD Vec3 mirrored(const SurfacePoint& surface, Vec3 w) {
    return w - 2 * dot(w, surface.ng) * surface.ng;
}

// T(w) of fold.h, w given in the shading frame: the world direction on that side of ng on which w
// is of n. Rounding has no say in that: where w and its mirror image both seem to lie in the face,
// or beyond, T(w) is lifted off the face by a little more than rounding can take.
HD_HOT Vec3 fold_to_world(const SurfacePoint& surface, Vec3 w) {
    const Vec3 world = surface.shading.to_world(w);
    if (w.z * dot(world, surface.ng) > 0) return world;
    const Vec3 folded = mirrored(surface, world);
    if (w.z * dot(folded, surface.ng) > 0) return folded;
    return folded + copysignf(0x1p-20f, w.z) * surface.ng;
}

} // namespace raylab
