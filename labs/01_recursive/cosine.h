// Diffuse reflection, and directions with the density that fits it.
//
//     f = albedo / pi,   pdf = cos / pi,   so that  f cos / pdf = albedo.
#pragma once

#include "common/material/bsdf_sample.h"
#include "common/sampling/warp.h"
#include "common/task/not_implemented.h"

namespace raylab::lab01 {

// A direction of the upper hemisphere with density cos(theta) / pi, by Malley's method: choose a
// point uniformly on the unit disk and lift it straight up to the hemisphere.
inline Vec3 sample_cosine(Vec2 u) {
    //[ task 1.5
    const Vec2 disk = sample_disk(u);
    // The disk's radius is the larger coordinate of the centred square: no rounding, and below 1.
    const Vec2 square = abs(centred(u));
    const float r = std::max(square.x, square.y);
    return Vec3(disk, sqrtf((1 - r) * (1 + r)));
    //| not_implemented("1.5", "sample_cosine()");
    //| return Vec3(0, 0, 1);
    //]
}

inline BsdfSample scatter_diffuse(Vec3 albedo, Vec2 u) {
    //[ task 1.5
    const Vec3 wi = sample_cosine(u);
    return {wi, albedo, wi.z * inv_pi, false, wi.z > 0};
    //| not_implemented("1.5", "scatter_diffuse()");
    //| return {};
    //]
}

// f cos and pdf of a given direction above the surface.
inline BsdfValue diffuse_value(Vec3 albedo, Vec3 wi) {
    //[ task 1.3
    return {albedo * (inv_pi * wi.z), wi.z * inv_pi};
    //| not_implemented("1.3", "diffuse_value()");
    //| return {};
    //]
}

} // namespace raylab::lab01
