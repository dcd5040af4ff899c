// Glass: how much light a smooth interface reflects, and in which direction the rest is refracted.
//
// Fresnel's equations for unpolarised light; Snell's law sin(theta_i) = eta sin(theta_t), where eta
// is the index of refraction on the far side over that on the near side.
#pragma once

#include "common/material/bsdf_sample.h"
#include "common/material/fresnel.h"
#include "common/task/not_implemented.h"

namespace raylab::lab01 {

// The part of light that is reflected; cos_i in [0, 1].
inline float reflected_part(float cos_i, float eta) {
    //[ task 1.6
    const float sin2_t = (1 - cos_i) * (1 + cos_i) / (eta * eta);
    if (sin2_t >= 1) return 1; // total internal reflection
    const float cos_t = sqrtf(1 - sin2_t);
    const float parallel = (eta * cos_i - cos_t) / (eta * cos_i + cos_t);
    const float perpendicular = (cos_i - eta * cos_t) / (cos_i + eta * cos_t);
    return (parallel * parallel + perpendicular * perpendicular) / 2;
    //| not_implemented("1.6", "reflected_part()");
    //| return 0;
    //]
}

// The refracted direction of wo, a unit vector with wo.z != 0 (local: z is the outward normal).
// Snell's law divides the part along the surface by eta. The part across follows from length 1.
inline Vec3 refracted_direction(Vec3 wo, float eta) {
    //[ task 1.6
    const Vec3 along = -Vec3(wo.x, wo.y, 0) / eta;
    return along - Vec3(0, 0, copysignf(safe_sqrt(1 - dot(along, along)), wo.z));
    //| not_implemented("1.6", "refracted_direction()");
    //| return -wo;
    //]
}

// Both ways on. The index inside is material.ior; wo.z > 0 is outside.
struct GlassSplit {
    Vec3 reflected, refracted;
    float reflectance; // 1: nothing is refracted
};

inline GlassSplit split_glass(const Material& material, Vec3 wo) {
    const float eta = wo.z > 0 ? material.ior : 1 / material.ior;
    const Vec3 refracted = refracted_direction(wo, eta);
    // A scene may ask for Schlick's approximation by name.
    const float reflectance = material.fresnel == FresnelModel::exact
                                  ? reflected_part(fabsf(wo.z), eta)
                                  : fresnel_dielectric_schlick(fabsf(wo.z), eta);
    return {Vec3(-wo.x, -wo.y, wo.z), refracted, reflectance};
}

// Chooses reflection with probability F, else refraction. F and 1 - F cancel out of the weight.
inline BsdfSample scatter_glass(const Material& material, Vec3 tint, Vec3 wo, float u_lobe) {
    //[ task 1.6
    const GlassSplit split = split_glass(material, wo);
    const bool reflects = u_lobe < split.reflectance;
    return {reflects ? split.reflected : split.refracted, tint, 0, true, true};
    //| not_implemented("1.6", "scatter_glass()");
    //| return {};
    //]
}

} // namespace raylab::lab01
