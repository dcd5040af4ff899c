// Rays that leave a surface. Their origin is moved off the surface, just far enough for every
// rounding error of the point. PBR4e 6.8 (Managing Rounding Error); here the point is first
// projected onto its surface in double.
//
// Every bound is relative to the coordinates of the point. No bound is a length in world units.
#pragma once

#include "common/trace/surface.h"

namespace raylab {

// p, moved to the side of its surface to which w points. It moves by twice the error: once for the
// rounding of p, once for the rounding of the sum. So the origin cannot lie on the wrong side.
HD_HOT Vec3 offset_point(Vec3 p, Vec3 ng, float error, Vec3 w) {
    return p + copysignf(2 * error, dot(w, ng)) * ng;
}

// The ray from a surface into the unit direction wi.
HD_HOT Ray spawn_ray(const SurfacePoint& surface, Vec3 wi) {
    return {offset_point(surface.p, surface.ng, surface.error, wi), wi};
}

// The shadow ray from a surface to the point `target`. Both its ends are moved off their surfaces,
// so occluded() finds only shapes between them. target_error: the largest distance along
// target_normal by which rounding puts the target off its surface; 0 for a point in space.
// target_normal: unit, on the side on which the shadow ray arrives. The caller gives this side,
// because at the rim of a small sphere the rounding of o would decide it wrongly.
HD_HOT Ray spawn_ray_to(const SurfacePoint& surface, Vec3 target, float target_error,
                        Vec3 target_normal) {
    const Vec3 o = offset_point(surface.p, surface.ng, surface.error, target - surface.p);
    // Rounding the direction moves its far end by a few ulps of the distance.
    const float aim_error = gamma_bound(4) * length(target - o);
    const Vec3 end = target + 2 * (target_error + aim_error) * target_normal;
    const float distance = length(end - o);
    return {o, (end - o) / distance, distance};
}

} // namespace raylab
