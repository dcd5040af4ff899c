// Both ways on from a surface that scatters in single directions only: what Whitted's tracer
// follows.
#pragma once

#include "common/material/bsdf.h"
#include "common/transport/face_side.h"

namespace raylab {

// Directions, and the share of their light that turns towards wo. A mirror only reflects.
struct SpecularSplit {
    Vec3 reflected = Vec3(0), reflected_weight = Vec3(0);
    Vec3 refracted = Vec3(0), refracted_weight = Vec3(0);
    bool refracts = false;
};

// material: is_specular. wo and what comes out: local.
template <Features F>
HD SpecularSplit split_specular(const Material& material, Vec3 reflectance, Vec3 wo) {
    if (is_clear<F>(material)) {
        const FresnelSplit split = fresnel_split(material, wo);
        return {split.reflected, reflectance * split.reflectance, split.refracted,
                reflectance * (1 - split.reflectance), split.reflectance < 1};
    }
    // The remaining lobes have one direction only, so their sample needs no random number.
    const BsdfSample sample = sample_bsdf<F>(material, reflectance, wo, 0, Vec2(0));
    return {sample.wi, sample.weight, Vec3(0), Vec3(0), false};
}

// Takes a split from the shading frame to the world, and folds its directions at the face (fold.h).
HD SpecularSplit fold_split(const SurfacePoint& surface, SpecularSplit split) {
    split.reflected = fold_to_world(surface, split.reflected);
    split.refracted = fold_to_world(surface, split.refracted);
    return split;
}

// The same around a surface's shading normal; wo and what comes out: world.
template <Features F>
HD SpecularSplit split_specular(const SurfacePoint& surface, const Material& material,
                                Vec3 reflectance, Vec3 wo) {
    return fold_split(surface,
                      split_specular<F>(material, reflectance, surface.shading.to_local(wo)));
}

} // namespace raylab
