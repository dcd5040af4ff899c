// Microfacets: a rough surface is a field of tiny mirrors, whose normals vary around the normal of
// the surface. Torrance and Sparrow 1967; Walter et al., Microfacet Models for Refraction through
// Rough Surfaces, EGSR 2007 (distributions, masking); PBR4e 9.6.
#pragma once

#include "common/material/material.h"
#include "common/sampling/warp.h"

namespace raylab {

// A distribution of normals m (unit, m.z > 0) and the masking that it causes. alpha: the roughness,
// a slope (tan of the angle from z) beyond which normals become rare. Directions are local; z is
// the normal of the surface.
//
// The formulas use x^2 + y^2 instead of 1 - z^2. Near m = z that difference has lost its digits
// (11 % error at alpha = 1e-3), but x and y have all of theirs.
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

    // Smith's masking: the part of the microfacets facing w that is visible from w. It is 1 at
    // normal incidence, 0 at grazing incidence, and the same on both sides of the surface.
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

    // Chooses a microfacet normal m for wo (wo.z > 0), with density pdf(wo, m).
    HD Vec3 sample(Vec3 wo, Vec2 u) const {
        return kind == Microfacets::ggx ? sample_visible_ggx(wo, u) : sample_beckmann(u);
    }

    // The density of m. GGX: over the normals visible from wo, D(m) G1(wo) (wo.m) / wo.z. Beckmann:
    // over all normals, D(m) m.z.
    HD float pdf(Vec3 wo, Vec3 m) const {
        if (kind == Microfacets::beckmann) return D(m) * m.z;
        return D(m) * dot(wo, m) * 2 / (wo.z + stretched_length(wo)); // G1(wo) / wo.z without 0/0
    }

    // The weight of a sampled normal, for F = 1: D G (wo.m) / (wo.z pdf), where D cancels and
    // G = G1(wo) G1(wi) (Walter et al., eq. 23). For GGX only G1(wi) is left, at most 1.
    HD float weight(Vec3 wo, Vec3 wi, Vec3 m) const {
        if (kind == Microfacets::ggx) return G1(wi);
        return G1(wo) * G1(wi) * dot(wo, m) / (wo.z * m.z);
    }

  private:
    // Length of w after the stretch that turns a GGX surface of roughness alpha into a hemisphere.
    HD float stretched_length(Vec3 w) const {
        return sqrtf(w.z * w.z + alpha * alpha * (w.x * w.x + w.y * w.y));
    }

    // After the stretch by alpha the surface is a hemisphere, and wo becomes w. The hemisphere
    // mirrors w into directions that fill the cap z > -w.z uniformly. So a direction is chosen in
    // the cap; the normal is half way between it and w (Dupuy and Benyoub, Sampling Visible GGX
    // Normals with Spherical Caps, 2023).
    HD Vec3 sample_visible_ggx(Vec3 wo, Vec2 u) const {
        const Vec3 w = normalize(Vec3(alpha * wo.x, alpha * wo.y, wo.z));
        const float below_top = u.y * (1 + w.z); // 1 - z of the direction in the cap
        const float r = safe_sqrt(below_top * (2 - below_top));
        const Vec2 c = r * cos_sin_turn(u.x);
        // Half way: the direction in the cap + w. Its z, (1 - u.y)(1 + w.z), is positive.
        const Vec3 h(c.x + w.x, c.y + w.y, (1 - u.y) * (1 + w.z));
        return normalize(Vec3(alpha * h.x, alpha * h.y, h.z));
    }

    // Inverts the distribution of D(m) m.z: tan^2 = -alpha^2 log(1 - u.x).
    HD Vec3 sample_beckmann(Vec2 u) const {
        const float tan2 = -alpha * alpha * log1pf(-u.x);
        const float z = 1 / sqrtf(1 + tan2);
        return Vec3(sqrtf(tan2) * z * cos_sin_turn(u.y), z);
    }
};

} // namespace raylab
