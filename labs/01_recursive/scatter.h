// One entry to all materials: diffuse and glass are this lab's own, the others are given.
//
// Each function stands here twice: for a material, with directions in the local frame, and for a
// surface, with directions in the world. The second is what the tracers call.
#pragma once

#include "common/transport/fold.h"
#include "common/transport/specular_split.h"
#include "labs/01_recursive/cosine.h"
#include "labs/01_recursive/glass.h"

namespace raylab::lab01 {

constexpr Features given_materials = feature::all & ~(feature::diffuse | feature::glass);

// A direction for light to come from. wo: local, z is the outward normal.
inline BsdfSample scatter(const Material& material, Vec3 reflectance, Vec3 wo, float u_lobe,
                          Vec2 u) {
    if (wo.z == 0) return {};
    if (material.kind == MaterialKind::glass)
        return scatter_glass(material, reflectance, wo, u_lobe);
    if (material.kind != MaterialKind::diffuse)
        return sample_bsdf<given_materials>(material, reflectance, wo, u_lobe, u);
    BsdfSample sample = scatter_diffuse(reflectance, u);
    if (wo.z < 0) sample.wi.z = -sample.wi.z; // a diffuse surface reflects on both sides
    return sample;
}

// f cos and pdf of two given directions.
inline BsdfValue evaluate(const Material& material, Vec3 reflectance, Vec3 wo, Vec3 wi) {
    if (material.kind != MaterialKind::diffuse)
        return evaluate_bsdf<given_materials>(material, reflectance, wo, wi);
    if (!(wo.z * wi.z > 0)) return {}; // nothing passes through
    return diffuse_value(reflectance, Vec3(wi.x, wi.y, fabsf(wi.z)));
}

// Both ways on from a mirror or from glass.
inline SpecularSplit split_light(const Material& material, Vec3 reflectance, Vec3 wo) {
    if (material.kind != MaterialKind::glass)
        return split_specular<given_materials>(material, reflectance, wo);
    const GlassSplit split = split_glass(material, wo);
    return {split.reflected, reflectance * split.reflectance, split.refracted,
            reflectance * (1 - split.reflectance), split.reflectance < 1};
}

// The same functions at a surface, with directions in the world. The local frame stands around the
// shading normal. No light passes through an opaque face; fold.h explains how this holds on smooth
// meshes, and that no energy is lost.
inline BsdfValue evaluate(const SurfacePoint& surface, const Material& material, Vec3 reflectance,
                          Vec3 wo, Vec3 wi) {
    return fold_value<feature::all>(surface, material, wo, wi, [&](Vec3 local_wo, Vec3 local_wi) {
        return evaluate(material, reflectance, local_wo, local_wi);
    });
}

inline BsdfSample scatter(const SurfacePoint& surface, const Material& material, Vec3 reflectance,
                          Vec3 wo, float u_lobe, Vec2 u) {
    const BsdfSample sample =
        scatter(material, reflectance, surface.shading.to_local(wo), u_lobe, u);
    return fold_sample<feature::all>(surface, material, wo, sample,
                                     [&](Vec3 local_wo, Vec3 local_wi) {
                                         return evaluate(material, reflectance, local_wo, local_wi);
                                     });
}

inline SpecularSplit split_light(const SurfacePoint& surface, const Material& material,
                                 Vec3 reflectance, Vec3 wo) {
    return fold_split(surface, split_light(material, reflectance, surface.shading.to_local(wo)));
}

} // namespace raylab::lab01
