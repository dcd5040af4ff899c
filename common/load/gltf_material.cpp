// From glTF's metallic-roughness model to the nearest of raylab's materials.
#include "common/load/gltf_material.h"

#include "common/material/bsdf.h"

#include <algorithm>
#include <cmath>

namespace raylab {
namespace {

float unit_number(const Node& holder, const std::string& key, float otherwise) {
    const auto node = holder.find(key);
    return node ? float(node->number(0, 1)) : otherwise;
}

// The first three of an array of three or four numbers.
Vec3 colour(const Node& node, double high = std::numeric_limits<double>::max()) {
    const std::vector<Node> c = node.elements();
    if (c.size() != 3 && c.size() != 4) node.fail_expected("an array of 3 or 4 numbers");
    return Vec3(c[0].number(0, high), c[1].number(0, high), c[2].number(0, high));
}

float alpha_of(const Node& rgba) {
    const std::vector<Node> c = rgba.elements();
    return c.size() == 4 ? float(c[3].number(0, 1)) : 1;
}

void read_core(const Node& root, const Node& material, GltfMaterial& m, GltfLosses& losses) {
    if (const auto pbr = material.find("pbrMetallicRoughness")) {
        if (const auto base = pbr->find("baseColorFactor")) {
            m.base_colour = colour(*base, 1);
            m.alpha = alpha_of(*base);
        }
        m.metallic = unit_number(*pbr, "metallicFactor", 1);
        m.roughness = unit_number(*pbr, "roughnessFactor", 1);
        m.base_texture = read_gltf_texture(root, *pbr, "baseColorTexture", losses);
        m.metallic_roughness_texture =
            read_gltf_texture(root, *pbr, "metallicRoughnessTexture", losses);
    }
    if (const auto emission = material.find("emissiveFactor")) m.emission = colour(*emission, 1);
    m.emissive_texture = read_gltf_texture(root, material, "emissiveTexture", losses);
    if (material.has("normalTexture")) losses.add("normal maps", "material");

    const std::string mode = material.has("alphaMode")
                                 ? material.at("alphaMode").word({"OPAQUE", "MASK", "BLEND"})
                                 : "OPAQUE";
    if (mode == "MASK")
        m.alpha_cutoff =
            material.has("alphaCutoff") ? float(material.at("alphaCutoff").not_negative()) : 0.5f;
    if (mode == "BLEND") {
        m.alpha_cutoff = 0.5f;
        losses.add("blending by alpha, which is cut at one half", "material");
    }
}

// The archived model of older exporters: diffuse + specular, no metals.
void read_specular_glossiness(const Node& root, const Node& node, GltfMaterial& m,
                              GltfLosses& losses) {
    m.base_colour = Vec3(1);
    m.alpha = 1;
    if (const auto diffuse = node.find("diffuseFactor")) {
        m.base_colour = colour(*diffuse, 1);
        m.alpha = alpha_of(*diffuse);
    }
    m.base_texture = read_gltf_texture(root, node, "diffuseTexture", losses);
    m.metallic = 0;
    m.metallic_roughness_texture = {};
    m.roughness = 1 - unit_number(node, "glossinessFactor", 1);
    m.f0 = node.has("specularFactor") ? colour(node.at("specularFactor"), 1) : Vec3(1);
    if (node.has("specularGlossinessTexture"))
        losses.add("specular-glossiness textures", "material");
}

void read_extensions(const Node& root, const Node& extensions, GltfMaterial& m,
                     GltfLosses& losses) {
    if (const auto strength = extensions.find("KHR_materials_emissive_strength"))
        if (const auto factor = strength->find("emissiveStrength"))
            m.emission *= float(factor->not_negative());
    if (const auto ior = extensions.find("KHR_materials_ior"))
        if (const auto index = ior->find("ior")) m.ior = float(index->not_negative());
    // Schlick's F at normal incidence. An index of 0 stands for "reflects everything".
    m.f0 = Vec3(m.ior == 0 ? 1 : float(std::pow((m.ior - 1) / (m.ior + 1), 2)));
    if (const auto specular = extensions.find("KHR_materials_specular")) {
        if (const auto tint = specular->find("specularColorFactor")) m.f0 *= colour(*tint);
        m.f0 = glm::min(m.f0, Vec3(1)) * unit_number(*specular, "specularFactor", 1);
        for (const char* key : {"specularTexture", "specularColorTexture"})
            if (specular->has(key)) losses.add("textures of KHR_materials_specular", "material");
    }
    if (const auto transmission = extensions.find("KHR_materials_transmission")) {
        m.transmission = unit_number(*transmission, "transmissionFactor", 0);
        if (transmission->has("transmissionTexture"))
            losses.add("transmission textures", "material");
    }
    if (const auto old = extensions.find("KHR_materials_pbrSpecularGlossiness"))
        read_specular_glossiness(root, *old, m, losses);
    for (const auto& [name, node] : extensions.members()) {
        const bool read = name == "KHR_materials_emissive_strength" ||
                          name == "KHR_materials_ior" || name == "KHR_materials_specular" ||
                          name == "KHR_materials_transmission" ||
                          name == "KHR_materials_pbrSpecularGlossiness";
        if (!read) losses.add(name, "material");
    }
}

// Roughness is the root of alpha (appendix B.3.2); alpha 0 is a perfect mirror.
float alpha_of_roughness(float roughness) { return std::max(roughness * roughness, 1e-4f); }

// The real index whose Fresnel reflectance at normal incidence is r: (eta - 1)^2 / (eta + 1)^2 = r.
// It grows beyond all bounds for r -> 1; .9999 is 1 to any eye.
float index_reflecting(float r) {
    const float root = std::sqrt(std::clamp(r, 0.0f, 0.9999f));
    return (1 + root) / (1 - root);
}

Material metal(const GltfMaterial& m) {
    Material result;
    result.kind = MaterialKind::conductor;
    result.fresnel = FresnelModel::schlick; // glTF's metals are f0 + (1 - f0) (1 - cos)^5
    result.alpha = alpha_of_roughness(m.roughness);
    result.k = Vec3(0);
    if (m.base_texture.exists()) {
        result.reflectance = m.base_colour; // times the texture, at all angles
        result.eta = Vec3(index_reflecting(1));
        return result;
    }
    result.reflectance = Vec3(1);
    const Vec3 f0 = (1 - m.metallic) * m.f0 + m.metallic * m.base_colour;
    for (int i = 0; i < 3; ++i) result.eta[i] = index_reflecting(f0[i]);
    return result;
}

Material glass(const GltfMaterial& m) {
    Material result;
    result.ior = clamp(m.ior, 1, 1e6f); // as far as Fresnel's equations hold in single precision
    result.alpha = alpha_of_roughness(m.roughness);
    result.kind = result.is_smooth() ? MaterialKind::glass : MaterialKind::rough_dielectric;
    result.reflectance = m.base_colour;
    return result;
}

// Diffuse below a coat. Phong's exponent for microfacets of roughness alpha: cos^n about the
// mirrored direction is as wide as cos^4n about the normal, and that is Blinn's 2 / alpha^2 - 2
// (Walter et al. 2007, section 5.2).
Material plastic(const GltfMaterial& m) {
    Material result;
    const float alpha = alpha_of_roughness(m.roughness);
    const float exponent = (2 / (alpha * alpha) - 2) / 4;
    const Vec3 diffuse = (1 - m.metallic) * m.base_colour;
    const Vec3 specular = (1 - m.metallic) * m.f0 + m.metallic * m.base_colour;
    const Vec3 below = diffuse * (1 - max_component(specular)); // what the coat lets through
    // A lobe as wide as that is no highlight any more: its light joins the diffuse part. A picture
    // would tint it there, so under one it stays a lobe.
    if (is_black(specular) || (exponent < 1 && !m.base_texture.exists())) {
        result.reflectance = below + specular;
        return result;
    }
    result.kind = MaterialKind::phong;
    result.exponent = clamp(exponent, 0, 1e5f);
    result.specular = specular;
    result.reflectance = below;
    return result;
}

} // namespace

GltfMaterial read_gltf_material(const Node& root, const Node& material, GltfLosses& losses) {
    GltfMaterial m;
    if (const auto name = material.find("name")) m.name = name->string();
    read_core(root, material, m, losses);
    if (const auto extensions = material.find("extensions"))
        read_extensions(root, *extensions, m, losses);
    return m;
}

Material nearest_material(const GltfMaterial& m) {
    Material result = m.transmission >= 0.5f && m.metallic < 0.5f ? glass(m)
                      : m.metallic >= 0.5f                        ? metal(m)
                                                                  : plastic(m);
    if (!is_clear(result)) result.emission = m.emission;
    return result;
}

const std::vector<std::string>& gltf_approximations() {
    static const std::vector<std::string> sentences{
        "A metal (metallic factor of at least 1/2) is a microfacet conductor, alpha = roughness^2, "
        "whose index reflects the base colour; under a base colour texture it reflects that colour "
        "at all angles.",
        "Any other opaque surface is a diffuse one below a Phong lobe as wide as the microfacets; "
        "from roughness 0.76 on both together are diffuse, but under a base colour texture. The "
        "lobe does not grow towards grazing angles.",
        "Rough metals lose the light that bounces between microfacets, as glTF's do.",
        "Transmission of at least 1/2 is solid glass, rough where roughness^2 is at least 0.001, "
        "tinted by the base colour; less transmission is none. Thin walls refract, volumes do not "
        "absorb, and glass does not glow.",
        "Metallic, roughness and emissive textures are replaced by their mean over each triangle, "
        "roughness in steps of 1/16.",
        "Alpha cuts triangles to pieces when the file is loaded, at least 1/4096 of the triangle "
        "or "
        "a texel in size; blending is cut at one half. The alpha of vertex colours is not read.",
        "Textures are bilinear whatever the file's filters say.",
        "A point light shines without a range; candela are taken for watts per steradian, as are "
        "candela per square metre for radiance.",
    };
    return sentences;
}

} // namespace raylab
