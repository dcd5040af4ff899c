#include "app/mitsuba_materials.h"

#include "app/mitsuba_xml.h"
#include "common/image/formats.h"

namespace raylab::app::mitsuba {

namespace {

std::string roughness(const Material& material) {
    return fmt::format("<float name=\"alpha\" value=\"{}\"/><string name=\"distribution\" "
                       "value=\"{}\"/>",
                       material.alpha,
                       material.microfacets == Microfacets::ggx ? "ggx" : "beckmann");
}

// The element that sets the wrap mode; empty for Mitsuba's default.
std::string wrap_mode(Wrap wrap) {
    if (wrap == Wrap::repeat) return "";
    return fmt::format("<string name=\"wrap_mode\" value=\"{}\"/>",
                       wrap == Wrap::clamp ? "clamp" : "mirror");
}

} // namespace

std::string id(const Scene& scene, int material) {
    return fmt::format("{}_{}", material, escaped(scene.material_names[material]));
}

// The element that gives a BSDF its parameter `name`: the material's reflectance, or its texture,
// whose texels are written unchanged.
std::string Materials::reflectance(const Material& material, const char* name) {
    if (material.texture < 0) return rgb(name, material.reflectance);
    const std::string file = fmt::format("texture_{}.pfm", material.texture);
    if (written_textures_.insert(material.texture).second) {
        const Texture& texture = scene_.textures[material.texture];
        if (texture.wrap_u != texture.wrap_v)
            refuse("a texture repeats, ends or is mirrored otherwise along u than along v, and "
                   "Mitsuba has one rule for both");
        Image image{texture.width, texture.height, {}, {}, {}};
        for (int row = texture.height - 1; row >= 0; --row) // ours have row 0 at the bottom
            for (int column = 0; column < texture.width; ++column)
                image.mean.push_back(scene_.texels[texture.first + row * texture.width + column]);
        files_.push_back({file, formats::encode_pfm(image)});
    }
    return fmt::format("<texture type=\"bitmap\" name=\"{}\"><string name=\"filename\" "
                       "value=\"{}\"/><boolean name=\"raw\" value=\"true\"/>{}</texture>",
                       name, file, wrap_mode(scene_.textures[material.texture].wrap_u));
}

std::string Materials::bsdf(int index) {
    const Material& m = scene_.materials[index];
    const std::string name = scene_.material_names[index];
    const auto opaque = [&](const char* type, const std::string& content) {
        return fmt::format("<bsdf type=\"twosided\" id=\"{}\"><bsdf type=\"{}\">{}</bsdf></bsdf>\n",
                           id(scene_, index), type, content);
    };
    const auto clear = [&](const char* type, const std::string& content) {
        return fmt::format("<bsdf type=\"{}\" id=\"{}\"><float name=\"int_ior\" value=\"{}\"/>"
                           "<float name=\"ext_ior\" value=\"1\"/>{}{}{}</bsdf>\n",
                           type, id(scene_, index), m.ior, content,
                           reflectance(m, "specular_reflectance"),
                           reflectance(m, "specular_transmittance"));
    };
    const bool has_fresnel = m.kind == MaterialKind::glass || m.kind == MaterialKind::conductor ||
                             m.kind == MaterialKind::rough_dielectric;
    if (has_fresnel && m.fresnel == FresnelModel::schlick)
        refuse(fmt::format("the material '{}' uses Schlick's approximation, and Mitsuba has "
                           "Fresnel's equations only",
                           name));
    switch (m.kind) {
    case MaterialKind::diffuse:
        return opaque("diffuse", reflectance(m, "reflectance"));
    case MaterialKind::mirror:
        return opaque("conductor", "<string name=\"material\" value=\"none\"/>" +
                                       reflectance(m, "specular_reflectance"));
    case MaterialKind::glass:
        return clear("dielectric", "");
    case MaterialKind::phong:
        refuse(fmt::format("the material '{}' is Phong's, which Mitsuba 3 does not have", name));
    case MaterialKind::conductor:
        return opaque(m.is_smooth() ? "conductor" : "roughconductor",
                      (m.is_smooth() ? "" : roughness(m)) + rgb("eta", m.eta) + rgb("k", m.k) +
                          reflectance(m, "specular_reflectance"));
    case MaterialKind::rough_dielectric:
        return m.is_smooth() || m.ior == 1 ? clear("dielectric", "")
                                           : clear("roughdielectric", roughness(m));
    }
    return {};
}

} // namespace raylab::app::mitsuba
