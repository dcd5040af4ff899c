// The materials of a glTF file as its triangles need them.
#include "common/load/gltf_look.h"

#include "common/image/display.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace raylab {
namespace {

// When a file has this many pieces, each further triangle is kept or removed as a whole.
constexpr std::size_t max_pieces = std::size_t(1) << 20;

} // namespace

GltfLook::GltfLook(const GltfFile& file, const std::string& name, const ReadNamedFile& read,
                   GltfLosses& losses)
    : file_(file), name_(name), read_(read), losses_(losses), materials_(1) {
    if (const auto materials = file.root.find("materials"))
        for (const Node& material : materials->elements())
            materials_.push_back(read_gltf_material(file.root, material, losses));
}

const Picture& GltfLook::picture(int image) {
    const auto found = pictures_.find(image);
    if (found != pictures_.end()) return found->second;
    return pictures_[image] = decode_picture(read_gltf_image(file_, image, read_),
                                             fmt::format("{}: image {}", name_, image));
}

void GltfLook::metallic_roughness(const GltfTexture& texture, const std::array<Vec2, 3>& uv,
                                  Variant& variant) {
    const Picture& p = picture(texture.image);
    // The file's numbers are linear, but decode_picture() decoded them as sRGB: this undoes it.
    const Vec3 mean = TexturePoint{p, texture}.mean(uv, [&](int texel) {
        const Vec3 c = p.texels[std::size_t(texel)];
        return Vec3(0, srgb_from_linear(c.y), srgb_from_linear(c.z));
    });
    const GltfMaterial& m = material(variant[0]);
    variant[1] = m.metallic * mean.z >= 0.5f;
    variant[2] = int(std::lround(16 * m.roughness * mean.y));
}

void GltfLook::emission(const GltfTexture& texture, const std::array<Vec2, 3>& uv,
                        Variant& variant) {
    const Picture& p = picture(texture.image);
    const Vec3 mean =
        TexturePoint{p, texture}.mean(uv, [&](int texel) { return p.texels[std::size_t(texel)]; });
    for (int i = 0; i < 3; ++i)
        variant[std::size_t(3 + i)] = int(std::lround(256 * std::min(mean[i], 1.0f)));
}

int GltfLook::material_of_variant(const Variant& variant) {
    const auto found = variants_.find(variant);
    if (found != variants_.end()) return found->second;
    GltfMaterial m = material(variant[0]);
    if (variant[1] >= 0) m.metallic = float(variant[1]);
    if (variant[2] >= 0) m.roughness = float(variant[2]) / 16;
    if (variant[3] >= 0)
        for (int i = 0; i < 3; ++i) m.emission[i] *= float(variant[std::size_t(3 + i)]) / 256;
    MeshMaterial result{
        m.name, nearest_material(m), -1, m.base_texture.wrap_u, m.base_texture.wrap_v, variant[0]};
    if (m.base_texture.exists()) {
        picture(m.base_texture.image); // read the picture now, so that its errors come first
        result.picture =
            picture_index_.try_emplace(m.base_texture.image, int(picture_index_.size()))
                .first->second;
    }
    results_.push_back(result);
    return variants_[variant] = int(results_.size()) - 1;
}

std::vector<Piece> GltfLook::pieces(int index, const std::array<Vec2, 3>& base_uv) {
    const GltfMaterial& m = material(index);
    if (m.alpha < m.alpha_cutoff) return {};
    auto cutout = cutouts_.find(index);
    if (cutout == cutouts_.end()) {
        std::unique_ptr<Cutout> made;
        if (m.base_texture.exists() && !picture(m.base_texture.image).alpha.empty())
            made = std::make_unique<Cutout>(picture(m.base_texture.image), m.base_texture, m.alpha,
                                            m.alpha_cutoff);
        cutout = cutouts_.emplace(index, std::move(made)).first;
    }
    if (!cutout->second) return {whole_triangle};
    const bool whole = pieces_ >= max_pieces;
    if (whole) losses_.add("fine edges of cut-outs", "triangle");
    std::vector<Piece> result = cutout->second->pieces(base_uv, whole ? 0 : 12);
    pieces_ += result.size();
    return result;
}

void GltfLook::finish(Mesh& mesh) {
    mesh.materials = std::move(results_);
    mesh.pictures.resize(picture_index_.size());
    for (const auto& [image, index] : picture_index_)
        mesh.pictures[std::size_t(index)] = std::move(pictures_.at(image));
}

} // namespace raylab
