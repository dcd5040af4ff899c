// One entry to all materials: sample_bsdf() chooses a direction, evaluate_bsdf() evaluates a pair.
//
// F is the set of features a kernel is compiled for (math/features.h): the kinds of material it
// lacks are not in the kernel. Local frame: z is the outward normal, wo.z < 0 means seen from
// inside. Opaque materials look the same from both sides. reflectance: the material's, or its
// texture's.
#pragma once

#include "common/material/conductor.h"
#include "common/material/diffuse.h"
#include "common/material/glass.h"
#include "common/material/mirror.h"
#include "common/material/phong.h"
#include "common/material/rough_dielectric.h"

namespace raylab {

// Calls ask(Bsdf<K>()) for the kind K of material, or returns Result{} if F has not that kind. The
// compiler refuses a kind without a line here, and a line without a Bsdf.
template <Features F, class Result, class Ask>
HD_HOT Result with_bsdf(MaterialKind kind, const Ask& ask) {
    const auto ask_if_in_kernel = [&]<MaterialKind K>(Bsdf<K> bsdf) -> Result {
        if constexpr ((F & feature_of(K)) != 0) return ask(bsdf);
        return {};
    };
    switch (kind) {
    case MaterialKind::diffuse:
        return ask_if_in_kernel(Bsdf<MaterialKind::diffuse>());
    case MaterialKind::mirror:
        return ask_if_in_kernel(Bsdf<MaterialKind::mirror>());
    case MaterialKind::glass:
        return ask_if_in_kernel(Bsdf<MaterialKind::glass>());
    case MaterialKind::phong:
        return ask_if_in_kernel(Bsdf<MaterialKind::phong>());
    case MaterialKind::conductor:
        return ask_if_in_kernel(Bsdf<MaterialKind::conductor>());
    case MaterialKind::rough_dielectric:
        return ask_if_in_kernel(Bsdf<MaterialKind::rough_dielectric>());
    }
    return {};
}

// The name of the kind in scene files.
inline const char* name_of(MaterialKind kind) {
    return with_bsdf<feature::all, const char*>(kind, [](auto bsdf) { return bsdf.name; });
}

// Does light pass through the material?
template <Features F = feature::all> HD bool is_clear(const Material& m) {
    return with_bsdf<F, bool>(m.kind, [](auto bsdf) { return bsdf.is_clear; });
}

// Does light leave the material in single directions only? Then light sampling is of no use.
template <Features F> HD bool is_specular(const Material& m) {
    return with_bsdf<F, bool>(m.kind, [&](auto bsdf) { return bsdf.is_specular(m); });
}

// f(wo, wi) |cos(theta_i)| and the density of wi. Delta lobes give 0.
template <Features F>
HD BsdfValue evaluate_bsdf(const Material& m, Vec3 reflectance, Vec3 wo, Vec3 wi) {
    return with_bsdf<F, BsdfValue>(m.kind, [&](auto bsdf) -> BsdfValue {
        if constexpr (bsdf.is_clear) {
            return bsdf.evaluate(m, reflectance, wo, wi);
        } else {
            if (!(wo.z * wi.z > 0)) return {}; // nothing passes an opaque surface
            return bsdf.evaluate(m, reflectance, Vec3(wo.x, wo.y, fabsf(wo.z)),
                                 Vec3(wi.x, wi.y, fabsf(wi.z)));
        }
    });
}

// A direction for light to come from. u_lobe chooses between reflection and refraction, or between
// lobes; u the direction. All three are in [0, 1).
template <Features F>
HD BsdfSample sample_bsdf(const Material& m, Vec3 reflectance, Vec3 wo, float u_lobe, Vec2 u) {
    if (wo.z == 0) return {};
    return with_bsdf<F, BsdfSample>(m.kind, [&](auto bsdf) -> BsdfSample {
        if constexpr (bsdf.is_clear) {
            return bsdf.sample(m, reflectance, wo, u_lobe, u);
        } else {
            const Vec3 above(wo.x, wo.y, fabsf(wo.z));
            BsdfSample sample = bsdf.sample(m, reflectance, above, u_lobe, u);
            if (wo.z < 0) sample.wi.z = -sample.wi.z;
            return sample;
        }
    });
}

} // namespace raylab
