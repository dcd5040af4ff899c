// A smooth dielectric interface: Fresnel decides how light splits into reflection and refraction.
// PBR4e 9.5 (Dielectric BSDF).
//
// Paths carry basic radiance L / n^2 (Nicodemus 1963). It is constant along a ray through any chain
// of refractions, so no refraction multiplies by eta^2. Basic radiance equals radiance if camera
// and lights stand in the same medium. A light inside the glass would look n^2 times too dim.
#pragma once

#include "common/material/bsdf_sample.h"
#include "common/material/fresnel.h"
#include "common/material/refract.h"

namespace raylab {

// The two directions in which a path goes on from a smooth interface. wo: local; z > 0 is outside.
// m.ior: the index inside, relative to outside.
struct FresnelSplit {
    Vec3 reflected, refracted; // local, unit
    float reflectance; // part of the light that is reflected; if 1, `refracted` has no meaning
};

HD FresnelSplit fresnel_split(const Material& m, Vec3 wo) {
    const float eta = wo.z > 0 ? m.ior : 1 / m.ior;
    const Refraction through = refract(wo, Vec3(0, 0, copysignf(1, wo.z)), eta);
    return {Vec3(-wo.x, -wo.y, wo.z), through.wi,
            through.total ? 1.0f : dielectric_reflectance(m, fabsf(wo.z), eta)};
}

//[ withhold 01
// Reflects with probability F and refracts with probability 1 - F. So F and 1 - F cancel out of the
// weight, and the tint is left.
HD BsdfSample sample_glass(const Material& m, Vec3 tint, Vec3 wo, float u_lobe) {
    const FresnelSplit split = fresnel_split(m, wo);
    const bool reflects = u_lobe < split.reflectance;
    return {reflects ? split.reflected : split.refracted, tint, 0, true,
            reflects || split.reflectance < 1};
}
//| namespace lab01 {
//| BsdfSample scatter_glass(const Material& material, Vec3 tint, Vec3 wo, float u_lobe); // task 1.6
//| }
//|
//| // Smooth glass is yours.
//| HD BsdfSample sample_glass(const Material& m, Vec3 tint, Vec3 wo, float u_lobe) {
//|     return lab01::scatter_glass(m, tint, wo, u_lobe);
//| }
//]

template <> struct Bsdf<MaterialKind::glass> {
    static constexpr const char* name = "glass";
    static constexpr bool is_clear = true;
    HD static bool is_specular(const Material&) { return true; }
    HD static BsdfValue evaluate(const Material&, Vec3, Vec3, Vec3) { return {}; }
    HD static BsdfSample sample(const Material& m, Vec3 tint, Vec3 wo, float u_lobe, Vec2) {
        return sample_glass(m, tint, wo, u_lobe);
    }
};

} // namespace raylab
