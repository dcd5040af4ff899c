// What a surface is made of, as plain data.
#pragma once

#include "common/math/features.h"
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
constexpr int material_kinds = static_cast<int>(MaterialKind::rough_dielectric) + 1;

// The bit of the kind in the set of features that a scene uses.
constexpr Features feature_of(MaterialKind kind) {
    return feature::first_material << static_cast<int>(kind);
}

namespace feature {
constexpr Features diffuse = feature_of(MaterialKind::diffuse);
constexpr Features mirror = feature_of(MaterialKind::mirror);
constexpr Features glass = feature_of(MaterialKind::glass);
constexpr Features phong = feature_of(MaterialKind::phong);
constexpr Features conductor = feature_of(MaterialKind::conductor);
constexpr Features rough_dielectric = feature_of(MaterialKind::rough_dielectric);
constexpr Features any_material = ((1u << material_kinds) - 1) * first_material;
} // namespace feature

enum class Microfacets : int { ggx, beckmann };
enum class FresnelModel : int { exact, schlick };

// Colours are linear RGB. A field whose comment names kinds of material is used by these kinds
// only.
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
    float alpha = 0.1f;              // conductor, rough_dielectric: roughness, not its square root
    int texture = -1;                // index of the texture that replaces reflectance, or -1
    Microfacets microfacets = Microfacets::ggx;
    FresnelModel fresnel = FresnelModel::exact; // schlick: the approximation

    // Below this roughness the lobe is narrower than float can resolve. The surface is then treated
    // as smooth, and no picture shows the difference (accuracy: GGX-SMOOTH).
    HD bool is_smooth() const { return alpha < 1e-3f; }
};

HD bool is_emissive(const Material& m) { return !is_black(m.emission); }

} // namespace raylab
