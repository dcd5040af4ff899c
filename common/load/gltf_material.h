// What glTF says about a surface, and the raylab material that comes nearest.
// glTF 2.0, section 3.9 and appendix B; the extensions KHR_materials_*.
#pragma once

#include "common/load/gltf_losses.h"
#include "common/load/gltf_texture.h"
#include "common/load/node.h"
#include "common/material/material.h"

#include <string>
#include <vector>

namespace raylab {

// The factors of one material, in the file's terms; a texture multiplies the factor beside it.
// As constructed it is the standard's default material.
struct GltfMaterial {
    std::string name = "glTF default";
    Vec3 base_colour = Vec3(1); // linear
    float alpha = 1;
    GltfTexture base_texture; // sRGB, and alpha
    float metallic = 1, roughness = 1;
    GltfTexture metallic_roughness_texture; // linear: green is roughness, blue is metallic
    Vec3 f0 = Vec3(0.04f);                  // what a non-metal reflects at normal incidence
    float transmission = 0, ior = 1.5f;
    Vec3 emission = Vec3(0);      // radiance (cd/m^2 in glTF), strength included
    GltfTexture emissive_texture; // sRGB
    // Where alpha is below this, the surface is cut out. 0: nowhere.
    float alpha_cutoff = 0;
};

// root: the whole file; material: one of its "materials". Throws SceneError for what is wrong;
// what raylab does not read is added to the losses.
GltfMaterial read_gltf_material(const Node& root, const Node& material, GltfLosses& losses);

// The material for a surface without textures, whose factors are the whole truth. Material::texture
// is left to the caller: where base_texture exists, it is to be multiplied by `reflectance`.
Material nearest_material(const GltfMaterial& material);

// What nearest_material() and the loader of meshes approximate, a sentence each.
const std::vector<std::string>& gltf_approximations();

} // namespace raylab
