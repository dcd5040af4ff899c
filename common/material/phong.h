// Diffuse reflection plus a Phong lobe that conserves energy. Lafortune and Willems, Using the
// Modified Phong Reflectance Model for Physically Based Rendering, 1994.
//
//   f = albedo / pi + specular (n + 2) / (2 pi) cos^n(alpha),
// where alpha is the angle between wi and the mirrored wo. With the factor (n + 2) / (2 pi) the
// lobe's albedo is `specular` at normal incidence. At other angles it is less, because a part of
// the lobe lies below the surface.
#pragma once

#include "common/material/diffuse.h"
#include "common/material/material.h"
#include "common/math/frame.h"

namespace raylab {

// cos^n of the angle between two unit vectors, 0 beyond a right angle. 1 - cos = |a - b|^2 / 2
// keeps the digits of a small angle. dot(a, b), near 1, has lost them, and a large n magnifies the
// error.
HD float cosine_power(Vec3 a, Vec3 b, float n) {
    const float one_minus_cos = length_squared(a - b) / 2;
    return one_minus_cos < 1 ? expf(n * log1pf(-one_minus_cos)) : 0.0f;
}

// The share of the samples that are drawn from the lobe: its share of the reflected light.
HD float phong_lobe_share(const Material& m, Vec3 albedo) {
    const float lobe = luminance(m.specular), diffuse = luminance(albedo);
    return lobe > 0 ? lobe / (lobe + diffuse) : 0.0f;
}

// wo, wi above the surface.
HD BsdfValue evaluate_phong(const Material& m, Vec3 albedo, Vec3 wo, Vec3 wi) {
    const float n = m.exponent;
    const float power = cosine_power(wi, Vec3(-wo.x, -wo.y, wo.z), n);
    const float share = phong_lobe_share(m, albedo);
    const BsdfValue diffuse = evaluate_diffuse(albedo, wi);
    return {diffuse.f_cos + m.specular * ((n + 2) * inv_two_pi * power * wi.z),
            (1 - share) * diffuse.pdf + share * ((n + 1) * inv_two_pi * power)};
}

// The lobe is sampled around the mirrored direction with density (n + 1) / (2 pi) cos^n(alpha),
// that is cos(alpha) = u^(1 / (n + 1)). Directions below the surface are dropped. The weight is f
// cos divided by the density of both lobes together, so it does not matter which lobe drew wi.
HD BsdfSample sample_phong(const Material& m, Vec3 albedo, Vec3 wo, float u_lobe, Vec2 u) {
    Vec3 wi;
    if (u_lobe < phong_lobe_share(m, albedo)) {
        const float v = -expm1f(logf(u.x) / (m.exponent + 1)); // 1 - cos(alpha)
        const Vec3 around_mirrored(sqrtf(v * (2 - v)) * cos_sin_turn(u.y), 1 - v);
        wi = Frame::around(Vec3(-wo.x, -wo.y, wo.z)).to_world(around_mirrored);
    } else {
        wi = sample_cosine_hemisphere(u);
    }
    if (!(wi.z > 0)) return {};
    const BsdfValue value = evaluate_phong(m, albedo, wo, wi);
    if (!(value.pdf > 0)) return {};
    return {wi, value.f_cos / value.pdf, value.pdf, false, true};
}

template <> struct Bsdf<MaterialKind::phong> {
    static constexpr const char* name = "phong";
    static constexpr bool is_clear = false;
    HD static bool is_specular(const Material&) { return false; }
    HD static BsdfValue evaluate(const Material& m, Vec3 albedo, Vec3 wo, Vec3 wi) {
        return evaluate_phong(m, albedo, wo, wi);
    }
    HD static BsdfSample sample(const Material& m, Vec3 albedo, Vec3 wo, float u_lobe, Vec2 u) {
        return sample_phong(m, albedo, wo, u_lobe, u);
    }
};

} // namespace raylab
