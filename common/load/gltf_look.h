// The materials of a glTF file as its triangles need them. A texture that no raylab material has
// (metallic, roughness, emission, alpha) is looked at where each triangle lies: its mean there
// chooses the triangle's material, and alpha cuts the triangle.
#pragma once

#include "common/load/gltf_cutout.h"
#include "common/load/gltf_data.h"
#include "common/load/gltf_material.h"

#include <map>
#include <memory>
#include <optional>

namespace raylab {

class GltfLook {
  public:
    // name: the file's, for messages. All must outlive this.
    GltfLook(const GltfFile& file, const std::string& name, const ReadNamedFile& read,
             GltfLosses& losses);

    // Of the file's material; -1: the standard's default.
    const GltfMaterial& material(int index) const { return materials_[std::size_t(index + 1)]; }

    // The mesh's material for a triangle, an index into what finish() hands over. uv_of(texture)
    // gives the triangle's texture coordinates in the texture's set.
    template <class UvOf> int material_of_triangle(int index, UvOf&& uv_of);

    // What alpha leaves of a triangle, for a material with an alpha_cutoff.
    std::vector<Piece> pieces(int index, const std::array<Vec2, 3>& base_uv);

    // Moves the materials and the pictures they use into the mesh.
    void finish(Mesh& mesh);

  private:
    // What distinguishes the materials made of one of the file's: metallic, roughness in
    // sixteenths, the emissive texture's mean in 256ths; -1: as the material says.
    using Variant = std::array<int, 6>;

    void metallic_roughness(const GltfTexture& texture, const std::array<Vec2, 3>& uv,
                            Variant& variant);
    void emission(const GltfTexture& texture, const std::array<Vec2, 3>& uv, Variant& variant);
    int material_of_variant(const Variant& variant);
    const Picture& picture(int image);

    const GltfFile& file_;
    const std::string& name_;
    const ReadNamedFile& read_;
    GltfLosses& losses_;
    std::vector<GltfMaterial> materials_;            // the default, then the file's
    std::map<int, Picture> pictures_;                // by image
    std::map<int, int> picture_index_;               // of those that are textures in the end
    std::map<int, std::unique_ptr<Cutout>> cutouts_; // by material; null: nothing is cut
    std::map<Variant, int> variants_;
    std::vector<MeshMaterial> results_;
    std::size_t pieces_ = 0;
};

template <class UvOf> int GltfLook::material_of_triangle(int index, UvOf&& uv_of) {
    const GltfMaterial& m = material(index);
    Variant variant{index, -1, -1, -1, -1, -1};
    if (m.metallic_roughness_texture.exists())
        metallic_roughness(m.metallic_roughness_texture, uv_of(m.metallic_roughness_texture),
                           variant);
    if (m.emissive_texture.exists() && !is_black(m.emission))
        emission(m.emissive_texture, uv_of(m.emissive_texture), variant);
    return material_of_variant(variant);
}

} // namespace raylab
