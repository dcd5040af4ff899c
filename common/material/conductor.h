// A metal: microfacets that reflect by the conductor's Fresnel equations. Torrance and Sparrow
// 1967; PBR4e 9.6.5.
//
//   f = F D G / (4 cos_o cos_i)
// The model leaves out light that bounces between microfacets, so rough metals are a little dark.
#pragma once

#include "common/material/bsdf_sample.h"
#include "common/material/fresnel.h"
#include "common/material/microfacet.h"
#include "common/material/mirror.h"
#include "common/material/refract.h"

namespace raylab {

// wo, wi above the surface.
HD BsdfValue evaluate_conductor(const Material& m, Vec3 factor, Vec3 wo, Vec3 wi) {
    if (m.is_smooth()) return {};
    const MicrofacetDistribution distribution{m.microfacets, m.alpha};
    const Vec3 normal = normalize(wo + wi);
    const float cosine = dot(wo, normal);
    if (!(cosine > 0)) return {};
    const float pdf = distribution.pdf(wo, normal) / (4 * cosine); // dm / dwi = 1 / (4 wo.m)
    const Vec3 reflectance = factor * conductor_reflectance(m, cosine);
    return {reflectance * (distribution.weight(wo, wi, normal) * pdf), pdf};
}

HD BsdfSample sample_conductor(const Material& m, Vec3 factor, Vec3 wo, Vec2 u) {
    if (m.is_smooth()) return sample_mirror(factor * conductor_reflectance(m, wo.z), wo);
    const MicrofacetDistribution distribution{m.microfacets, m.alpha};
    const Vec3 normal = distribution.sample(wo, u);
    const Vec3 wi = reflect(wo, normal);
    const float cosine = dot(wo, normal);
    if (!(cosine > 0 && wi.z > 0)) return {}; // m is seen from behind, or wi is below the surface
    const float pdf = distribution.pdf(wo, normal) / (4 * cosine);
    const Vec3 reflectance = factor * conductor_reflectance(m, cosine);
    return {wi, reflectance * distribution.weight(wo, wi, normal), pdf, false, pdf > 0};
}

template <> struct Bsdf<MaterialKind::conductor> {
    static constexpr const char* name = "conductor";
    static constexpr bool is_clear = false;
    HD static bool is_specular(const Material& m) { return m.is_smooth(); }
    HD static BsdfValue evaluate(const Material& m, Vec3 factor, Vec3 wo, Vec3 wi) {
        return evaluate_conductor(m, factor, wo, wi);
    }
    HD static BsdfSample sample(const Material& m, Vec3 factor, Vec3 wo, float, Vec2 u) {
        return sample_conductor(m, factor, wo, u);
    }
};

} // namespace raylab
