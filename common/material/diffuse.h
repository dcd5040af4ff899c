// Lambert's diffuse reflection: f = albedo / pi, the same for all directions. PBR4e 9.2.
#pragma once

#include "common/material/bsdf_sample.h"
#include "common/sampling/warp.h"

namespace raylab {

//[ withhold 01
// wo, wi above the surface. For a wi with density cos/pi, the weight f cos / pdf is the albedo.
HD_HOT BsdfValue evaluate_diffuse(Vec3 albedo, Vec3 wi) {
    return {albedo * (inv_pi * wi.z), cosine_hemisphere_pdf(wi.z)};
}

HD_HOT BsdfSample sample_diffuse(Vec3 albedo, Vec2 u) {
    const Vec3 wi = sample_cosine_hemisphere(u);
    return {wi, albedo, cosine_hemisphere_pdf(wi.z), false, wi.z > 0};
}
//| // What other materials take from a diffuse surface is yours.
//| namespace lab01 {
//| BsdfValue diffuse_value(Vec3 albedo, Vec3 wi);   // task 1.3
//| BsdfSample scatter_diffuse(Vec3 albedo, Vec2 u); // task 1.5
//| }
//|
//| HD BsdfValue evaluate_diffuse(Vec3 albedo, Vec3 wi) { return lab01::diffuse_value(albedo, wi); }
//| HD BsdfSample sample_diffuse(Vec3 albedo, Vec2 u) { return lab01::scatter_diffuse(albedo, u); }
//]

template <> struct Bsdf<MaterialKind::diffuse> {
    static constexpr const char* name = "diffuse";
    static constexpr bool is_clear = false;
    HD static bool is_specular(const Material&) { return false; }
    HD static BsdfValue evaluate(const Material&, Vec3 albedo, Vec3, Vec3 wi) {
        return evaluate_diffuse(albedo, wi);
    }
    HD static BsdfSample sample(const Material&, Vec3 albedo, Vec3, float, Vec2 u) {
        return sample_diffuse(albedo, u);
    }
};

} // namespace raylab
