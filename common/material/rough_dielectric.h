// Rough glass: microfacets that reflect and refract. Walter et al., Microfacet Models for
// Refraction through Rough Surfaces, EGSR 2007; PBR4e 9.7.
//
// Paths carry basic radiance, as with smooth glass (glass.h). Sampling chooses a normal m. It then
// reflects at m with probability F(wo.m), or else refracts, so F and 1 - F cancel out of the
// weight.
#pragma once

#include "common/material/glass.h"
#include "common/material/microfacet.h"

namespace raylab {

// If the indices are equal, light goes straight through, even if the interface is rough.
HD bool is_smooth_dielectric(const Material& m) { return m.is_smooth() || m.ior == 1; }

// The Jacobian dm / dwi of the normal m that refracts wo to wi: solid angle of normals over solid
// angle of wi.
HD float refraction_jacobian(Vec3 wo, Vec3 wi, Vec3 m, float eta) {
    return fabsf(dot(wi, m)) / sqr(dot(wi, m) + dot(wo, m) / eta);
}

HD BsdfValue evaluate_rough_dielectric(const Material& m, Vec3 tint, Vec3 wo, Vec3 wi) {
    if (is_smooth_dielectric(m) || wo.z == 0 || wi.z == 0) return {};
    const float eta = wo.z > 0 ? m.ior : 1 / m.ior;
    if (wo.z < 0) wo.z = -wo.z, wi.z = -wi.z; // seen from inside: turn z over

    // The microfacet normal that takes wo to wi: along wo + wi for reflection, along wo + eta wi
    // for refraction. It is turned to wo's side of the surface, z > 0.
    const bool reflects = wi.z > 0;
    Vec3 normal = normalize(reflects ? wo + wi : wo + eta * wi);
    if (normal.z < 0) normal = -normal;
    const float cosine = dot(wo, normal), cosine_i = dot(wi, normal);
    if (!(cosine > 0 && (cosine_i > 0) == reflects)) return {}; // m is seen from behind

    const MicrofacetDistribution distribution{m.microfacets, m.alpha};
    const float F = dielectric_reflectance(m, cosine, eta);
    const float pdf =
        distribution.pdf(wo, normal) *
        (reflects ? F / (4 * cosine) : (1 - F) * refraction_jacobian(wo, wi, normal, eta));
    return {tint * (distribution.weight(wo, wi, normal) * pdf), pdf};
}

HD BsdfSample sample_rough_dielectric(const Material& m, Vec3 tint, Vec3 wo, float u_lobe, Vec2 u) {
    if (is_smooth_dielectric(m)) return sample_glass(m, tint, wo, u_lobe);
    const float eta = wo.z > 0 ? m.ior : 1 / m.ior;
    const float side = copysignf(1, wo.z);
    wo.z = fabsf(wo.z);

    const MicrofacetDistribution distribution{m.microfacets, m.alpha};
    const Vec3 normal = distribution.sample(wo, u);
    const float cosine = dot(wo, normal);
    if (!(cosine > 0)) return {};
    const Refraction through = refract(wo, normal, eta);
    const float F = through.total ? 1.0f : dielectric_reflectance(m, cosine, eta);
    const bool reflects = u_lobe < F;
    Vec3 wi = reflects ? reflect(wo, normal) : through.wi;
    if (!(reflects ? wi.z > 0 : wi.z < 0)) return {}; // wi is on the wrong side of the surface

    const float pdf =
        distribution.pdf(wo, normal) *
        (reflects ? F / (4 * cosine) : (1 - F) * refraction_jacobian(wo, wi, normal, eta));
    const float weight = distribution.weight(wo, wi, normal);
    wi.z *= side;
    return {wi, tint * weight, pdf, false, pdf > 0};
}

template <> struct Bsdf<MaterialKind::rough_dielectric> {
    static constexpr const char* name = "rough_dielectric";
    static constexpr bool is_clear = true;
    HD static bool is_specular(const Material& m) { return is_smooth_dielectric(m); }
    HD static BsdfValue evaluate(const Material& m, Vec3 tint, Vec3 wo, Vec3 wi) {
        return evaluate_rough_dielectric(m, tint, wo, wi);
    }
    HD static BsdfSample sample(const Material& m, Vec3 tint, Vec3 wo, float u_lobe, Vec2 u) {
        return sample_rough_dielectric(m, tint, wo, u_lobe, u);
    }
};

} // namespace raylab
