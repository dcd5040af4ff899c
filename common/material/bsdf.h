// One interface for all materials: sample_bsdf() chooses a direction, and evaluate_bsdf() evaluates
// the BSDF for a pair of directions.
//
// F is the set of features for which a kernel is compiled (math/features.h). The kernel has no code
// for kinds of material that are not in F. Directions are local: z is the outward normal, and
// wo.z < 0 means that the surface is seen from inside. Opaque materials look the same from both
// sides. reflectance: the material's own, or the value of its texture.
#pragma once

#include "common/material/conductor.h"
#include "common/material/diffuse.h"
#include "common/material/glass.h"
#include "common/material/mirror.h"
#include "common/material/phong.h"
#include "common/material/rough_dielectric.h"

namespace raylab {

// Calls ask(Bsdf<K>()) with K = kind, or returns Result{} if this kind is not in F. The compiler
// refuses a kind that has no line here, and a line whose kind has no Bsdf.
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

// Does the material scatter light into single directions only? Then light sampling is of no use.
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

// Chooses a direction wi from which light may come. u_lobe chooses between reflection and
// refraction, or between lobes; u chooses the direction. All three numbers are in [0, 1).
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
