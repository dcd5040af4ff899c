// How a surface scatters: the BSDF of its material, around its shading normal, folded at the face
// (fold.h). All directions are world's.
#pragma once

#include "common/material/bsdf.h"
#include "common/transport/fold.h"

namespace raylab {

// f(wo, wi) |cos(theta_i)| and the density of wi; nothing passes an opaque surface.
template <Features F>
HD_HOT BsdfValue evaluate_bsdf(const SurfacePoint& surface, const Material& m, Vec3 reflectance,
                               Vec3 wo, Vec3 wi) {
    return fold_value<F>(surface, m, wo, wi, [&](Vec3 local_wo, Vec3 local_wi) {
        return evaluate_bsdf<F>(m, reflectance, local_wo, local_wi);
    });
}

// A direction for light to come from.
template <Features F>
HD_HOT BsdfSample sample_bsdf(const SurfacePoint& surface, const Material& m, Vec3 reflectance,
                              Vec3 wo, float u_lobe, Vec2 u) {
    const BsdfSample sample =
        sample_bsdf<F>(m, reflectance, surface.shading.to_local(wo), u_lobe, u);
    return fold_sample<F>(surface, m, wo, sample, [&](Vec3 local_wo, Vec3 local_wi) {
        return evaluate_bsdf<F>(m, reflectance, local_wo, local_wi);
    });
}

} // namespace raylab
