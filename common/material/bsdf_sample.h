// What BSDFs give to an integrator. PBR4e 9.1 (BSDF Representation).
//
// Directions are local: z is the surface's outward normal, and both wo (to the viewer) and wi (to
// the light) point away from the surface.
#pragma once

#include "common/material/material.h"

namespace raylab {

// A direction chosen by the BSDF.
struct BsdfSample {
    Vec3 wi = Vec3(0);
    Vec3 weight = Vec3(0); // f(wo, wi) |cos(theta_i)| / pdf: a factor on the throughput
    float pdf = 0; // of wi, per solid angle; 0 for a delta lobe, which has no finite density
    bool specular = false; // wi comes from a delta lobe: no light sample could have found it
    bool valid = false;    // false: the path ends, because it carries no light
};

// The BSDF for a given pair of directions; delta lobes count as 0.
struct BsdfValue {
    Vec3 f_cos = Vec3(0); // f(wo, wi) |cos(theta_i)|, 1/sr
    float pdf = 0;        // the density with which sampling chooses wi, 1/sr
};

// The file of each material specialises Bsdf for its kind, with these members:
//
//     static constexpr const char* name;         // in scene files
//     static constexpr bool is_clear;            // does light pass through it?
//     static bool is_specular(const Material&);  // does it scatter in single directions only?
//     static BsdfValue evaluate(const Material&, Vec3 reflectance, Vec3 wo, Vec3 wi);
//     static BsdfSample sample(const Material&, Vec3 reflectance, Vec3 wo, float u_lobe, Vec2 u);
//
// The functions of an opaque material get directions above its surface only: wo.z, wi.z > 0.
template <MaterialKind> struct Bsdf;

} // namespace raylab
