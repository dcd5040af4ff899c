// One entry to all materials: sample a direction, evaluate a pair of directions.
//
// F is the set of features a kernel is compiled for (math/features.h): the kinds of material it
// lacks are not in the kernel. Local frame: z is the outward normal, wo.z < 0 means seen from
// inside. Opaque materials look the same from both sides. reflectance: the material's, or its
// texture's.
#pragma once

#include "common/material/bsdf_sample.h"
#include "common/material/conductor.h"
#include "common/material/diffuse.h"
#include "common/material/glass.h"
#include "common/material/mirror.h"
#include "common/material/phong.h"
#include "common/material/rough_dielectric.h"
#include "common/math/features.h"

namespace raylab {

// Does light leave the material in single directions only? Then light sampling is of no use.
template <Features F> HD bool is_specular(const Material& m) {
    switch (m.kind) {
    case MaterialKind::mirror:
        return (F & feature::mirror) != 0;
    case MaterialKind::glass:
        return (F & feature::glass) != 0;
    case MaterialKind::conductor:
        return (F & feature::conductor) && m.is_smooth();
    case MaterialKind::rough_dielectric:
        return (F & feature::rough_dielectric) && is_smooth_dielectric(m);
    default:
        return false;
    }
}

// f(wo, wi) |cos(theta_i)| and the density of wi. Delta lobes give 0.
template <Features F>
HD BsdfValue evaluate_bsdf(const Material& m, Vec3 reflectance, Vec3 wo, Vec3 wi) {
    if constexpr ((F & feature::rough_dielectric) != 0)
        if (m.kind == MaterialKind::rough_dielectric)
            return evaluate_rough_dielectric(m, reflectance, wo, wi);

    if (!(wo.z * wi.z > 0)) return {}; // nothing passes an opaque surface
    wo.z = fabsf(wo.z);
    wi.z = fabsf(wi.z);
    switch (m.kind) {
    case MaterialKind::diffuse:
        if constexpr ((F & feature::diffuse) != 0) return evaluate_diffuse(reflectance, wi);
        break;
    case MaterialKind::phong:
        if constexpr ((F & feature::phong) != 0) return evaluate_phong(m, reflectance, wo, wi);
        break;
    case MaterialKind::conductor:
        if constexpr ((F & feature::conductor) != 0)
            return evaluate_conductor(m, reflectance, wo, wi);
        break;
    default:
        break;
    }
    return {};
}

// A direction for light to come from. u_lobe chooses between reflection and refraction, or between
// lobes; u the direction. All three are in [0, 1).
template <Features F>
HD BsdfSample sample_bsdf(const Material& m, Vec3 reflectance, Vec3 wo, float u_lobe, Vec2 u) {
    if (wo.z == 0) return {};
    const Vec3 up(wo.x, wo.y, fabsf(wo.z));
    BsdfSample sample;
    switch (m.kind) {
    case MaterialKind::diffuse:
        if constexpr ((F & feature::diffuse) != 0) sample = sample_diffuse(reflectance, u);
        break;
    case MaterialKind::mirror:
        if constexpr ((F & feature::mirror) != 0) sample = sample_mirror(reflectance, up);
        break;
    case MaterialKind::phong:
        if constexpr ((F & feature::phong) != 0)
            sample = sample_phong(m, reflectance, up, u_lobe, u);
        break;
    case MaterialKind::conductor:
        if constexpr ((F & feature::conductor) != 0)
            sample = sample_conductor(m, reflectance, up, u);
        break;
    case MaterialKind::glass:
        if constexpr ((F & feature::glass) != 0) return sample_glass(m, reflectance, wo, u_lobe);
        break;
    case MaterialKind::rough_dielectric:
        if constexpr ((F & feature::rough_dielectric) != 0)
            return sample_rough_dielectric(m, reflectance, wo, u_lobe, u);
        break;
    }
    if (wo.z < 0) sample.wi.z = -sample.wi.z;
    return sample;
}

} // namespace raylab
