// glTF 2.0 and GLB by tinygltf: the triangles of the file's scene in the rest pose, with their
// materials and point lights. docs/formats.md says what is read, warned of and refused.
#include "common/load/gltf_camera.h"
#include "common/load/gltf_check.h"
#include "common/load/gltf_light.h"
#include "common/load/gltf_look.h"
#include "common/load/gltf_pose.h"
#include "common/load/gltf_vertices.h"
#include "common/load/scene_builder.h"
#include "common/load/scene_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

namespace raylab {
namespace {

class GltfReader {
  public:
    GltfReader(const GltfFile& file, const std::string& name, const ReadNamedFile& read,
               MeshLook look)
        : file_(file), model_(file.model), name_(name), nodes_(file) {
        if (look == MeshLook::own) look_.emplace(file, name, read, losses_);
    }

    Mesh read() {
        const auto json = file_.root.find("nodes");
        const std::vector<Node> nodes = json ? json->elements() : std::vector<Node>{};
        for (const int index : nodes_.order) {
            const tinygltf::Node& node = model_.nodes[index];
            if (node.mesh >= int(model_.meshes.size()))
                nodes[index].fail(fmt::format("mesh {} does not exist; the file has {}", node.mesh,
                                              model_.meshes.size()));
            if (node.mesh >= 0) read_mesh(node, nodes[index], *nodes_.to_world[index]);
            if (const auto light =
                    read_gltf_light(file_.root, nodes[index], *nodes_.to_world[index], losses_))
                mesh_.lights.push_back(*light);
            if (look_) // without it only geometry and lights are read
                if (auto camera = read_gltf_camera(file_.root, nodes[index],
                                                   *nodes_.to_world[index], losses_))
                    mesh_.cameras.push_back(*camera);
        }
        if (mesh_.triangles.empty())
            throw SceneError(
                name_ + ": expected triangles in its scene, found none" +
                (cut_out_ > 0 ? fmt::format(": alpha cuts all {} out", cut_out_) : ""));
        if (look_) look_->finish(mesh_);
        note_other_losses();
        if (const std::string lost = losses_.sentence(name_); !lost.empty())
            mesh_.warnings.push_back(lost);
        return std::move(mesh_);
    }

  private:
    // One triangle of a primitive, before it is placed.
    struct Part {
        std::array<int, 3> corner;
        int material;
        std::vector<Piece> pieces; // none: the whole
    };

    void read_mesh(const tinygltf::Node& node, const Node& json, const Transform& to_world) {
        std::vector<Transform> instances = instances_of(file_, json, to_world);
        std::vector<Transform> joints;
        if (node.skin >= 0) {
            if (node.skin >= count_of("skins"))
                json.fail(fmt::format("skin {} does not exist; the file has {}", node.skin,
                                      count_of("skins")));
            joints = joints_of(file_, nodes_, node.skin);
        }
        const tinygltf::Mesh& mesh = model_.meshes[node.mesh];
        const std::vector<double>& weights = node.weights.empty() ? mesh.weights : node.weights;
        for (const tinygltf::Primitive& primitive : mesh.primitives) {
            const int mode = primitive.mode;
            if (mode != TINYGLTF_MODE_TRIANGLES && mode != TINYGLTF_MODE_TRIANGLE_STRIP &&
                mode != TINYGLTF_MODE_TRIANGLE_FAN) {
                losses_.add("points and lines, which have no surface", "primitive");
                continue;
            }
            check_material(primitive, node.mesh);
            GltfVertices vertices = read_gltf_vertices(file_, node.mesh, primitive, weights,
                                                       uv_sets(primitive), losses_);
            supply_uvs(primitive, vertices);
            const std::vector<Part> parts = look_at(primitive, vertices);
            const std::vector<Transform> bound =
                joints.empty() ? std::vector<Transform>{}
                               : read_gltf_binding(file_, node.mesh, primitive,
                                                   int(vertices.positions.size()), joints);
            if (!bound.empty()) { // a bound mesh stands where its joints do (section 3.7.3.3)
                place(vertices, parts, primitive.material, node.mesh,
                      [&](int vertex) -> const Transform& { return bound[vertex]; });
                continue;
            }
            for (const Transform& instance : instances)
                place(vertices, parts, primitive.material, node.mesh,
                      [&](int) -> const Transform& { return instance; });
        }
    }

    void check_material(const tinygltf::Primitive& primitive, int mesh) {
        const int material = primitive.material;
        if (material < -1 || material >= count_of("materials"))
            fail_in_mesh(mesh, fmt::format("material {} does not exist; the file has {}", material,
                                           count_of("materials")));
    }

    // The numbers of the texture coordinate sets that the primitive's material uses.
    std::set<int> uv_sets(const tinygltf::Primitive& primitive) {
        if (!look_) return {0};
        const GltfMaterial& m = look_->material(primitive.material);
        std::set<int> sets{m.base_texture.uv_set};
        for (const GltfTexture* texture : {&m.metallic_roughness_texture, &m.emissive_texture})
            if (texture->exists()) sets.insert(texture->uv_set);
        return sets;
    }

    // A texture without texture coordinates shows one place, as in viewers.
    void supply_uvs(const tinygltf::Primitive& primitive, GltfVertices& vertices) {
        if (!look_) return;
        const GltfTexture& texture = look_->material(primitive.material).base_texture;
        if (!texture.exists() || vertices.uvs.contains(texture.uv_set)) return;
        vertices.uvs[texture.uv_set].assign(vertices.positions.size(), Vec2(0));
        losses_.add("texture coordinates that a texture needs", "primitive");
    }

    // The triangles with their materials, without the parts that alpha cuts out.
    std::vector<Part> look_at(const tinygltf::Primitive& primitive, const GltfVertices& vertices) {
        const int material = primitive.material;
        std::vector<Part> parts;
        for (std::size_t i = 0; i + 2 < vertices.corners.size(); i += 3) {
            Part part{
                {vertices.corners[i], vertices.corners[i + 1], vertices.corners[i + 2]}, -1, {}};
            if (look_) {
                const auto uv_of = [&](const GltfTexture& texture) {
                    std::array<Vec2, 3> uv{};
                    if (const auto set = vertices.uvs.find(texture.uv_set);
                        set != vertices.uvs.end())
                        for (int k = 0; k < 3; ++k) uv[k] = set->second[part.corner[k]];
                    return uv;
                };
                if (look_->material(material).alpha_cutoff > 0) {
                    part.pieces =
                        look_->pieces(material, uv_of(look_->material(material).base_texture));
                    if (part.pieces.empty()) {
                        ++cut_out_;
                        continue;
                    }
                    if (part.pieces[0] == whole_triangle) part.pieces.clear();
                }
                part.material = look_->material_of_triangle(material, uv_of);
            }
            parts.push_back(std::move(part));
        }
        return parts;
    }

    template <class TransformOf>
    void place(const GltfVertices& vertices, const std::vector<Part>& parts, int material, int mesh,
               TransformOf&& transform_of) {
        std::size_t pieces = 0;
        for (const Part& part : parts) pieces += std::max<std::size_t>(1, part.pieces.size());
        if (mesh_.positions.size() + vertices.positions.size() > max_triangles ||
            mesh_.triangles.size() + pieces > max_triangles)
            fail_in_mesh(mesh,
                         fmt::format("the file has more than {} triangles or vertices, nodes and "
                                     "instances expanded; use a smaller mesh",
                                     max_triangles));
        const GltfTexture texture = look_ ? look_->material(material).base_texture : GltfTexture{};
        const auto uvs = vertices.uvs.find(texture.uv_set);
        const bool has_normals = !vertices.normals.empty(), has_uvs = uvs != vertices.uvs.end(),
                   has_colours = look_ && !vertices.colours.empty();
        const int base = int(mesh_.positions.size()), base_normal = int(mesh_.normals.size()),
                  base_uv = int(mesh_.uvs.size()), base_colour = int(mesh_.colours.size());
        for (int i = 0; i < int(vertices.positions.size()); ++i) {
            const Transform& to_world = transform_of(i);
            mesh_.positions.push_back(to_world.point(vertices.positions[i]));
            if (has_normals) mesh_.normals.push_back(to_world.normal(vertices.normals[i]));
            if (has_uvs) {
                const Vec2 uv = texture.transform(uvs->second[i]);
                if (!std::isfinite(uv.x) || !std::isfinite(uv.y))
                    fail_in_mesh(mesh, "a texture transform takes texture coordinates beyond "
                                       "single precision (3.4e38)");
                mesh_.uvs.emplace_back(uv.x, 1 - uv.y); // glTF's v points down
            }
            if (has_colours) mesh_.colours.push_back(vertices.colours[i]);
        }
        for (const Part& part : parts) {
            MeshTriangle whole;
            whole.material = part.material;
            const bool turn = transform_of(part.corner[0]).mirrors(); // it turns triangles over
            for (int k = 0; k < 3; ++k) {
                const int corner = part.corner[k > 0 && turn ? 3 - k : k];
                whole.position[k] = base + corner;
                if (has_normals) whole.normal[k] = base_normal + corner;
                if (has_uvs) whole.uv[k] = base_uv + corner;
                if (has_colours) whole.colour[k] = base_colour + corner;
            }
            if (part.pieces.empty()) mesh_.triangles.push_back(whole);
            for (Piece piece : part.pieces) {
                if (turn) // corners 1 and 2 have changed places, and so must the piece's
                    for (Vec3& b : piece) std::swap(b.y, b.z);
                if (turn) std::swap(piece[1], piece[2]);
                mesh_.triangles.push_back(cut(whole, piece));
            }
        }
    }

    // A piece of a triangle of the mesh, with vertices of its own.
    MeshTriangle cut(const MeshTriangle& whole, const Piece& piece) {
        const auto interpolate = [&](auto& values, const std::array<int, 3>& of,
                                     std::array<int, 3>& to) {
            if (of[0] < 0) return;
            for (int k = 0; k < 3; ++k) {
                using T = std::decay_t<decltype(values[0])>;
                using Number = typename T::value_type;
                T sum(0);
                for (int c = 0; c < 3; ++c) sum += Number(piece[k][c]) * values[of[c]];
                to[k] = int(values.size());
                values.push_back(sum);
            }
        };
        MeshTriangle part = whole;
        interpolate(mesh_.positions, whole.position, part.position);
        interpolate(mesh_.normals, whole.normal, part.normal);
        interpolate(mesh_.uvs, whole.uv, part.uv);
        interpolate(mesh_.colours, whole.colour, part.colour);
        return part;
    }

    void note_other_losses() {
        if (const auto animations = file_.root.find("animations"))
            for (std::size_t i = 0; i < animations->elements().size(); ++i)
                losses_.add("animations: everything is in its rest pose", "animation");
        const auto used = file_.root.find("extensionsUsed");
        if (!used) return;
        static constexpr std::array read{"KHR_mesh_quantization", "KHR_texture_transform",
                                         "KHR_lights_punctual", "EXT_mesh_gpu_instancing"};
        for (const Node& extension : used->elements()) {
            const std::string name = extension.string();
            // Extensions of materials were counted where the materials were read, except for
            // variants, which belong to primitives. Leaving out metadata is no loss.
            const bool is_counted =
                name.starts_with("KHR_materials_") && !(look_ && name == "KHR_materials_variants");
            if (!is_counted && !name.starts_with("KHR_xmp") &&
                std::find(read.begin(), read.end(), name) == read.end())
                losses_.add(name, "extension");
        }
    }

    // The number of elements of a top-level array.
    int count_of(const std::string& array) {
        const auto [count, is_new] = counts_.try_emplace(array, 0);
        if (!is_new) return count->second;
        const auto node = file_.root.find(array);
        return count->second = node ? int(node->elements().size()) : 0;
    }

    [[noreturn]] void fail_in_mesh(int mesh, const std::string& what) const {
        file_.json("meshes", mesh).fail(what);
    }

    const GltfFile& file_;
    const tinygltf::Model& model_;
    const std::string& name_;
    GltfNodes nodes_;
    GltfLosses losses_;
    std::map<std::string, int> counts_;
    int cut_out_ = 0;              // triangles
    std::optional<GltfLook> look_; // nothing: geometry alone
    Mesh mesh_;
};

} // namespace

Mesh parse_gltf(std::string_view bytes, const std::string& name, const ReadNamedFile& read,
                MeshLook look) {
    const bool binary = bytes.starts_with("glTF");
    const std::string_view text = binary ? json_chunk(bytes, name) : bytes;
    const JsonDocument document = parse_json(text, binary ? name + " (its JSON chunk)" : name);
    const Node root(document);
    check_version(root);
    check_extensions(root);
    check_buffer_views(root);
    const tinygltf::Model model = load_model(bytes, binary, name, read);
    const GltfFile file{model, root};
    return GltfReader(file, name, read, look).read();
}

} // namespace raylab
