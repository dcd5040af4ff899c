// The section `materials`: what surfaces are made of, by name, and their textures.
#include "common/load/keys.h"
#include "common/load/picture.h"
#include "common/load/scene_builder.h"
#include "common/load/scene_error.h"
#include "common/load/suggest.h"
#include "common/material/bsdf.h"

#include <fmt/format.h>

namespace raylab {
namespace {

// Fresnel's equations need the fourth power of an index, which leaves single precision near 1e9;
// and beyond a million there is nothing to be seen.
constexpr double largest_index = 1e6;
constexpr const char* beyond =
    "; beyond, the surface reflects all light but millionths: take a mirror";

double refractive_index(const Node& node) {
    const double index = node.positive();
    if (index < 1 / largest_index || index > largest_index)
        node.fail_expected("an index of refraction from 1e-6 to 1e6", beyond);
    return index;
}

} // namespace

void SceneBuilder::read_materials(const Node& materials) {
    for (const auto& [name, node] : materials.members())
        material_index_[name] = add_material(read_material(node), name);
}

int SceneBuilder::add_material(const Material& material, const std::string& name) {
    scene_.materials.push_back(material);
    scene_.material_names.push_back(name);
    return int(scene_.materials.size()) - 1;
}

Material SceneBuilder::read_material(const Node& node) {
    node.expect_object();
    using Kind = MaterialKind;
    Material m;
    const Node kind = node.at("kind");
    std::vector<std::pair<std::string, Kind>> kinds;
    for (int k = 0; k < material_kinds; ++k) kinds.emplace_back(name_of(Kind(k)), Kind(k));
    m.kind = kind.one_of(kinds);
    node.expect_keys(scene_keys().at("material " + kind.string()),
                     "a material of kind " + kind.string());

    // A material that only reflects must give its reflectance. Glass and metal have no tint unless
    // they give one.
    if (const auto texture = node.find("reflectance_texture")) {
        if (node.has("reflectance"))
            texture->fail("expected reflectance or reflectance_texture, found both; remove one");
        m.texture = texture_from_file(*texture);
    } else if (m.kind == Kind::diffuse || m.kind == Kind::mirror || m.kind == Kind::phong) {
        m.reflectance = node.at("reflectance").rgb(1);
    } else {
        m.reflectance = node.has("reflectance") ? node.at("reflectance").rgb(1) : Vec3(1);
    }
    if (const auto emission = node.find("emission")) m.emission = emission->rgb();

    if (m.kind == Kind::phong) {
        const Node specular = node.at("specular");
        m.specular = specular.rgb(1);
        m.exponent = float(node.at("exponent").not_negative());
        if (max_component(m.reflectance + m.specular) > 1 + 4 * unit_roundoff)
            specular.fail(
                "expected reflectance + specular of at most 1 in each channel, found more: "
                "the surface would reflect more light than it gets; lower one of them");
    }
    if (m.kind == Kind::conductor) {
        m.k = node.at("k").rgb();
        for (const Node& channel : node.at("k").elements())
            if (channel.number() > largest_index)
                channel.fail_expected("an absorption index of at most 1e6", beyond);
        m.eta = node.at("eta").rgb();
        for (const Node& channel : node.at("eta").elements()) refractive_index(channel);
    }
    if (const auto ior = node.find("ior")) m.ior = float(refractive_index(*ior));
    if (const auto alpha = node.find("alpha")) {
        m.alpha = float(alpha->positive());
        if (m.alpha > 1) alpha->fail_expected("a roughness greater than 0 and at most 1");
    }
    if (const auto n = node.find("microfacets"))
        m.microfacets = n->one_of<Microfacets>(
            {{"ggx", Microfacets::ggx}, {"beckmann", Microfacets::beckmann}});
    if (const auto n = node.find("fresnel"))
        m.fresnel = n->one_of<FresnelModel>(
            {{"exact", FresnelModel::exact}, {"schlick", FresnelModel::schlick}});
    return m;
}

int SceneBuilder::material_named(const Node& name) {
    const std::string wanted = name.string();
    if (const auto found = material_index_.find(wanted); found != material_index_.end())
        return found->second;
    std::vector<std::string> known;
    for (const auto& [material, index] : material_index_) known.push_back(material);
    name.fail_expected("the name of a material",
                       did_you_mean(wanted, known) + (known.empty()
                                                          ? "; the scene has no materials"
                                                          : "; the scene has " + one_of(known)));
}

int SceneBuilder::texture_from_file(const Node& file) {
    const std::string path = (folder_ / file.string()).lexically_normal().string();
    if (const auto found = texture_index_.find(path); found != texture_index_.end())
        return found->second;
    const std::string bytes = read_named_file(file);
    try {
        return texture_index_[path] = add_texture(decode_picture(bytes, path), file);
    } catch (const SceneError& error) {
        file.fail(error.what());
    }
}

// factor: multiplied into every texel here, so that no hit has to do it.
int SceneBuilder::add_texture(const Picture& picture, const Node& node, Vec3 factor, Wrap wrap_u,
                              Wrap wrap_v) {
    if (scene_.texels.size() + picture.texels.size() > std::size_t(max_picture_texels))
        node.fail(fmt::format("the scene's textures have more than {} texels; scale them down",
                              max_picture_texels));
    scene_.textures.push_back(
        {int(scene_.texels.size()), picture.width, picture.height, wrap_u, wrap_v});
    for (int y = picture.height - 1; y >= 0; --y) { // row 0 of a texture is its bottom
        const auto row = picture.texels.begin() + std::ptrdiff_t(y) * picture.width;
        for (auto texel = row; texel != row + picture.width; ++texel)
            scene_.texels.push_back(factor * *texel);
    }
    return int(scene_.textures.size()) - 1;
}

} // namespace raylab
