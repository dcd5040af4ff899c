// What a surface is made of, as plain data.
#pragma once

#include "common/math/vec.h"

namespace raylab {

enum class MaterialKind : int {
    diffuse,          // Lambert
    mirror,           // perfect reflection
    glass,            // smooth dielectric: Fresnel reflection and refraction
    phong,            // diffuse + energy-conserving Phong lobe
    conductor,        // microfacet metal
    rough_dielectric, // microfacet glass
};

enum class Microfacets : int { ggx, beckmann };
enum class FresnelModel : int { exact, schlick };

// Colours are linear RGB. Fields a kind does not name are unused by it.
struct Material {
    MaterialKind kind = MaterialKind::diffuse;
    // diffuse: albedo; mirror: reflectance; phong: albedo of the diffuse part;
    // conductor: factor on the Fresnel reflectance; glass, rough_dielectric: tint of both lobes.
    Vec3 reflectance = Vec3(0.5f);
    Vec3 specular = Vec3(0);         // phong: albedo of the lobe at normal incidence
    Vec3 emission = Vec3(0);         // radiance, both sides of the surface
    Vec3 eta = Vec3(1), k = Vec3(0); // conductor: complex index of refraction eta + i k
    float ior = 1.5f;                // glass, rough_dielectric: inside over outside
    float exponent = 1;              // phong
    float alpha = 0.1f;              // microfacet roughness (not its root)
    int texture = -1;                // index of the texture that replaces reflectance, or -1
    Microfacets microfacets = Microfacets::ggx;
    FresnelModel fresnel = FresnelModel::exact; // schlick: the labelled approximation

    // Below this roughness the lobe is narrower than float can resolve: treat it as smooth.
    // Roughness that a surface would show only under a microscope (accuracy: GGX-SMOOTH).
    HD bool is_smooth() const { return alpha < 1e-3f; }
};

HD bool is_emissive(const Material& m) { return !is_black(m.emission); }

} // namespace raylab
