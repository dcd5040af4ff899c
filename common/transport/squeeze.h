// Diffuse light around a tilted shading normal: all of it stays above the face, spread evenly.
//
// Seen along n, directions are points of the unit disk, and diffuse light, f |cos| = albedo / pi
// |cos|, covers it evenly (Nusselt's analog). With x towards the side to which ng leans and k =
// sqrt(1 - y^2), the face hides the part x < -c k, c = n.ng. Each line of constant y is squeezed
// into what is left of it,
//   S: [-k, k] -> [-c k, k],   x' = k - (k - x) (1 + c) / 2,
// by the same factor everywhere. So the disk stays evenly covered:
//   f' |cos| = f |cos| 2 / (1 + c),   pdf' = pdf 2 / (1 + c)   above the face, 0 below,
// and the integral of f' is that of f. Nothing is brighter where it grazes the face.
#pragma once

#include "common/material/bsdf_sample.h"
#include "common/math/numbers.h"
#include "common/transport/face_side.h"

namespace raylab {

// 1 / ((1 + c) / 2); exactly 1 where n is ng.
HD float squeeze_gain(const SurfacePoint& surface) {
    const Vec3& n = surface.shading.z;
    return n == surface.ng ? 1.0f : 2 / (1 + dot(n, surface.ng));
}

// S(w); w and the result are in the shading frame. The back of the face hides the other side of the
// disk.
HD Vec3 squeezed(const SurfacePoint& surface, Vec3 w) {
    const Vec3 ng = surface.shading.to_local(surface.ng);
    const float length = sqrtf(ng.x * ng.x + ng.y * ng.y);
    if (surface.shading.z == surface.ng || !(length > 0)) return w;
    const Vec2 aside = copysignf(1 / length, w.z) * Vec2(ng.x, ng.y);
    const float x = aside.x * w.x + aside.y * w.y, y = aside.x * w.y - aside.y * w.x;
    const float k = safe_sqrt(1 - y * y);
    const float rest = (k - x) / squeeze_gain(surface), moved = k - rest;
    const float z = copysignf(safe_sqrt(rest * (k + moved)), w.z); // z^2 = k^2 - x'^2
    return Vec3(moved * aside.x - y * aside.y, moved * aside.y + y * aside.x, z);
}

// f' |cos| and pdf'. wo, wi: world. evaluate(wo, wi): the diffuse BSDF in the shading frame.
template <class Evaluate>
HD_HOT BsdfValue squeeze_value(const SurfacePoint& surface, Vec3 wo, Vec3 wi,
                               const Evaluate& evaluate) {
    const Vec3 local = surface.shading.to_local(wi);
    if (!(dot(wi, surface.ng) * local.z > 0)) return {};
    const BsdfValue value = evaluate(surface.shading.to_local(wo), local);
    const float gain = squeeze_gain(surface);
    return {gain * value.f_cos, gain * value.pdf};
}

// A sample of the diffuse BSDF, drawn in the shading frame, becomes one of f', world. f / pdf
// stays.
template <class Evaluate>
HD_HOT BsdfSample squeeze_sample(const SurfacePoint& surface, Vec3 wo, BsdfSample sample,
                                 const Evaluate& evaluate) {
    const Vec3 w = squeezed(surface, sample.wi);
    sample.wi = fold_to_world(surface, w);
    if (surface.shading.z == surface.ng) return sample;
    sample.pdf = squeeze_gain(surface) * evaluate(surface.shading.to_local(wo), w).pdf;
    sample.valid = sample.pdf > 0;
    return sample;
}

} // namespace raylab
