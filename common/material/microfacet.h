// Microfacets: a rough surface as a field of tiny mirrors whose normals scatter around the
// surface's. Torrance and Sparrow 1967; Walter et al., Microfacet Models for Refraction through
// Rough Surfaces, EGSR 2007 (distributions, masking); PBR4e 9.6.
#pragma once

#include "common/material/material.h"
#include "common/sampling/warp.h"

namespace raylab {

// A distribution of normals m (unit, m.z > 0) and the masking it causes. alpha: the slope, tan of
// the angle, at which the normals thin out. Directions are local, z the surface's normal.
//
// Everything is written in x and y, not in 1 - z^2: near m = z that difference has no digits left
// (11 % error at alpha = 1e-3), while x and y keep all theirs.
struct MicrofacetDistribution {
    Microfacets kind;
    float alpha;

    // Density of microfacet area over its normals: the integral of D(m) m.z over the hemisphere
    // is 1.
    //   GGX:      alpha^2 / (pi (x^2 + y^2 + alpha^2 z^2)^2)
    //   Beckmann: exp(-tan^2 / alpha^2) / (pi alpha^2 z^4)
    HD float D(Vec3 m) const {
        const float r2 = m.x * m.x + m.y * m.y, z2 = m.z * m.z, a2 = alpha * alpha;
        if (kind == Microfacets::ggx) return inv_pi / (a2 * sqr(r2 / a2 + z2));
        return expf(-r2 / (z2 * a2)) * inv_pi / (a2 * z2 * z2);
    }

    // Smith's masking: the part of the microfacets facing w that w sees, 1 at normal incidence, 0
    // at grazing. Both sides of the surface are masked alike.
    //   GGX:      2 / (1 + sqrt(1 + alpha^2 tan^2))
    //   Beckmann: 2 / (1 + erf(a) + exp(-a^2) / (a sqrt(pi))),  a = 1 / (alpha tan)
    HD float G1(Vec3 w) const {
        const float z = fabsf(w.z);
        if (kind == Microfacets::ggx) return 2 * z / (z + stretched_length(w));
        const float at = alpha * sqrtf(w.x * w.x + w.y * w.y); // a = z / at
        if (at == 0) return 1;
        const float a = z / at;
        constexpr float inv_sqrt_pi = 0.564189583547756286948f;
        return 2 * a / (a * (1 + erff(a)) + expf(-a * a) * inv_sqrt_pi);
    }

    // Chooses a normal for light seen from wo (wo.z > 0); its density is pdf(wo, m).
    HD Vec3 sample(Vec3 wo, Vec2 u) const {
        return kind == Microfacets::ggx ? sample_visible_ggx(wo, u) : sample_beckmann(u);
    }

    // GGX: the normals that wo sees, D(m) G1(wo) (wo.m) / wo.z. Beckmann: all, D(m) m.z.
    HD float pdf(Vec3 wo, Vec3 m) const {
        if (kind == Microfacets::beckmann) return D(m) * m.z;
        return D(m) * dot(wo, m) * 2 / (wo.z + stretched_length(wo)); // G1(wo) / wo.z without 0/0
    }

    // What a sampled normal is worth, for F = 1: D G (wo.m) / (wo.z pdf), with D cancelled and
    // G = G1(wo) G1(wi) (Walter et al., eq. 23). For GGX just G1(wi): never above 1.
    HD float weight(Vec3 wo, Vec3 wi, Vec3 m) const {
        if (kind == Microfacets::ggx) return G1(wi);
        return G1(wo) * G1(wi) * dot(wo, m) / (wo.z * m.z);
    }

  private:
    // Length of w after the stretch that turns a GGX surface of roughness alpha into a hemisphere.
    HD float stretched_length(Vec3 w) const {
        return sqrtf(w.z * w.z + alpha * alpha * (w.x * w.x + w.y * w.y));
    }

    // Stretched by alpha the surface is a hemisphere, and the mirrored directions of light from wo
    // off it fill, uniformly, the cap of directions with z > -wo.z; the normal is half way between
    // (Dupuy and Benyoub, Sampling Visible GGX Normals with Spherical Caps, 2023).
    HD Vec3 sample_visible_ggx(Vec3 wo, Vec2 u) const {
        const Vec3 w = normalize(Vec3(alpha * wo.x, alpha * wo.y, wo.z));
        const float below_top = u.y * (1 + w.z); // 1 - z of the cap's point
        const float r = safe_sqrt(below_top * (2 - below_top));
        const Vec2 c = r * cos_sin_turn(u.x);
        // Half way: cap's point + w. Its z, (1 - u)(1 + w.z), is positive for every u < 1.
        const Vec3 h(c.x + w.x, c.y + w.y, (1 - u.y) * (1 + w.z));
        return normalize(Vec3(alpha * h.x, alpha * h.y, h.z));
    }

    // tan^2 = -alpha^2 log(1 - u).
    HD Vec3 sample_beckmann(Vec2 u) const {
        const float tan2 = -alpha * alpha * log1pf(-u.x);
        const float z = 1 / sqrtf(1 + tan2);
        return Vec3(sqrtf(tan2) * z * cos_sin_turn(u.y), z);
    }
};

} // namespace raylab
