// How much a smooth interface reflects: Fresnel's equations for unpolarised light.
// PBR4e 9.3.5 (the Fresnel equations for dielectrics), 9.3.6 (for conductors).
//
// cos_i: cosine between direction and normal, in [0, 1]. eta: the index of refraction behind the
// surface divided by the index in front of it. For light that enters glass it is 1.5, for light
// that leaves glass 1/1.5.
#pragma once

#include "common/material/material.h"
#include "common/math/numbers.h"

namespace raylab {

// (eta cos_t)^2 = eta^2 - sin_i^2, by Snell's law; 0 or less means total internal reflection. It is
// computed in double, where both products are exact: near the critical angle the difference is
// small, and F depends on its root.
HD float refracted_cos2(float cos_i, float eta) {
    const double c = cos_i, n = eta;
    return static_cast<float>((n * n - 1) + c * c);
}

//[ withhold 01
// F, the part of the light that is reflected; 1 under total internal reflection. Error below 1e-6.
HD float fresnel_dielectric(float cos_i, float eta) {
    cos_i = clamp(cos_i, 0, 1);
    const float cos2 = refracted_cos2(cos_i, eta);
    if (cos2 <= 0) return 1;
    const float s = sqrtf(cos2); // eta cos_t
    const float perpendicular = (cos_i - s) / (cos_i + s);
    const float parallel = (eta * eta * cos_i - s) / (eta * eta * cos_i + s);
    return (sqr(parallel) + sqr(perpendicular)) / 2;
}
//| namespace lab01 {
//| float reflected_part(float cos_i, float eta); // task 1.6
//| }
//|
//| // 1 under total internal reflection: yours.
//| HD float fresnel_dielectric(float cos_i, float eta) {
//|     return lab01::reflected_part(clamp(cos_i, 0, 1), eta);
//| }
//]

// Schlick's approximation of F (1994): r0 at normal incidence, 1 at grazing incidence.
HD float schlick(float r0, float cosine) {
    const float m = 1 - clamp(cosine, 0, 1);
    return r0 + (1 - r0) * (m * m) * (m * m) * m;
}

// Schlick's approximation for a dielectric; its error reaches 0.21 (ior 1.1) near grazing
// incidence. It takes the larger of the two angles, which lies on the side with the smaller index.
// For light from inside this is the refracted angle; if there is none, the reflection is total.
HD float fresnel_dielectric_schlick(float cos_i, float eta) {
    cos_i = clamp(cos_i, 0, 1);
    const float cos2 = refracted_cos2(cos_i, eta);
    if (cos2 <= 0) return 1;
    return schlick(sqr((eta - 1) / (eta + 1)), eta < 1 ? sqrtf(cos2) / eta : cos_i);
}

// The index of a metal is complex, n = eta + i k, relative to the medium in front. So Fresnel's
// amplitudes are complex. Their squared moduli are computed with real numbers, from a + i b, the
// root of n^2 - sin^2:
//   a^2 + b^2 = |n^2 - sin^2|,  a^2 = (|n^2 - sin^2| + Re(n^2 - sin^2)) / 2.
HD float fresnel_conductor(float cos_i, float eta, float k) {
    cos_i = clamp(cos_i, 0, 1);
    const float cos2 = cos_i * cos_i, sin2 = (1 - cos_i) * (1 + cos_i);
    // In double, as above: near eta = 1 the difference is small.
    const double c = cos_i, n = eta, absorption = k;
    const float re = static_cast<float>((n * n - 1) - absorption * absorption + c * c);
    const float im = 2 * eta * k;
    const float modulus = sqrtf(re * re + im * im);
    // a = Re sqrt(re + i im). For re < 0 the sum in a^2 cancels; then a follows from a b = im / 2.
    const float larger = sqrtf((modulus + fabsf(re)) / 2);
    const float a = re >= 0 ? larger : im / (2 * larger);

    const float s1 = modulus + cos2, s2 = 2 * a * cos_i;
    const float perpendicular = (s1 - s2) / (s1 + s2);
    const float p1 = modulus * cos2 + sin2 * sin2, p2 = s2 * sin2;
    const float parallel = perpendicular * (p1 - p2) / (p1 + p2);
    return (perpendicular + parallel) / 2;
}

// The part of the light that a material reflects at cos_i, by the material's Fresnel model.
HD float dielectric_reflectance(const Material& m, float cos_i, float eta) {
    return m.fresnel == FresnelModel::exact ? fresnel_dielectric(cos_i, eta)
                                            : fresnel_dielectric_schlick(cos_i, eta);
}

HD float conductor_reflectance(FresnelModel model, float cos_i, float eta, float k) {
    return model == FresnelModel::exact ? fresnel_conductor(cos_i, eta, k)
                                        : schlick(fresnel_conductor(1, eta, k), cos_i);
}

HD Vec3 conductor_reflectance(const Material& m, float cos_i) {
    return Vec3(conductor_reflectance(m.fresnel, cos_i, m.eta.x, m.k.x),
                conductor_reflectance(m.fresnel, cos_i, m.eta.y, m.k.y),
                conductor_reflectance(m.fresnel, cos_i, m.eta.z, m.k.z));
}

} // namespace raylab
