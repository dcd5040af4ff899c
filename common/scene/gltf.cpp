// glTF 2.0 and GLB by tinygltf: the triangles of the default scene, each node's transform applied,
// with the base colours of their materials. glTF 2.0 specification, sections 3.5 to 3.9.
#include "common/scene/gltf_data.h"
#include "common/scene/mesh.h"
#include "common/scene/scene_builder.h"
#include "common/scene/scene_error.h"

#include <fmt/format.h>

namespace raylab {
namespace {

Transform transform_of(const tinygltf::Node& node) {
    Transform transform;
    if (node.matrix.size() == 16) { // column by column
        for (int column = 0; column < 3; ++column)
            for (int row = 0; row < 3; ++row)
                transform.linear[column][row] = node.matrix[column * 4 + row];
        transform.translation = DVec3(node.matrix[12], node.matrix[13], node.matrix[14]);
        return transform;
    }
    if (node.rotation.size() == 4) {
        const DVec3 v(node.rotation[0], node.rotation[1], node.rotation[2]);
        const double w = node.rotation[3], sine = std::sqrt(dot(v, v)); // of half the angle
        if (sine > 0) transform.linear = rotation(v / sine, 2 * std::atan2(sine, w));
    }
    if (node.scale.size() == 3)
        for (int axis = 0; axis < 3; ++axis) transform.linear[axis] *= node.scale[axis];
    if (node.translation.size() == 3)
        transform.translation =
            DVec3(node.translation[0], node.translation[1], node.translation[2]);
    return transform;
}

class GltfReader {
  public:
    GltfReader(const GltfFile& file, const std::string& name, const ReadNamedFile& read)
        : file_(file), model_(file.model), name_(name), read_(read) {}

    Mesh read() {
        visited_.assign(model_.nodes.size(), false);
        picture_of_image_.assign(model_.images.size(), -1);
        for (int i = 0; i < int(model_.materials.size()); ++i) read_material(i);
        read_nodes();
        if (mesh_.triangles.empty())
            throw SceneError(name_ + ": expected triangles in its scene, found none");
        return std::move(mesh_);
    }

  private:
    void read_material(int index) {
        const tinygltf::Material& material = model_.materials[index];
        const tinygltf::PbrMetallicRoughness& pbr = material.pbrMetallicRoughness;
        MeshMaterial result{material.name, Vec3(1), -1};
        if (pbr.baseColorFactor.size() >= 3)
            for (int i = 0; i < 3; ++i) {
                if (!(pbr.baseColorFactor[i] >= 0 && pbr.baseColorFactor[i] <= 1))
                    file_.json("materials", index)
                        .fail("expected a baseColorFactor of numbers from 0 to 1");
                result.reflectance[i] = float(pbr.baseColorFactor[i]);
            }
        if (const int texture = pbr.baseColorTexture.index; texture >= 0) {
            const bool known = texture < int(model_.textures.size());
            const int image = known ? model_.textures[texture].source : -1;
            if (image < 0 || image >= int(model_.images.size()))
                file_.json("materials", index)
                    .fail(fmt::format("the baseColorTexture {} does not exist or has no image",
                                      texture));
            result.picture = picture_of(image);
        }
        mesh_.materials.push_back(result);
    }

    int picture_of(int index) {
        int& picture = picture_of_image_[index];
        if (picture >= 0) return picture;
        const tinygltf::Image& image = model_.images[index];
        const std::string name = fmt::format("{}: image {}", name_, index);
        if (image.bufferView >= 0) {
            mesh_.pictures.push_back(decode_picture(view_bytes(file_, image.bufferView), name));
        } else if (!image.uri.empty()) {
            mesh_.pictures.push_back(decode_picture(read_(image.uri), image.uri));
        } else {
            const std::string_view bytes(reinterpret_cast<const char*>(image.image.data()),
                                         image.image.size());
            mesh_.pictures.push_back(decode_picture(bytes, name));
        }
        return picture = int(mesh_.pictures.size()) - 1;
    }

    // The nodes of the default scene, or of the first, or all that are nobody's children.
    std::vector<int> roots() const {
        const int scene = model_.defaultScene < 0 ? 0 : model_.defaultScene;
        if (scene < int(model_.scenes.size())) return model_.scenes[scene].nodes;
        if (!model_.scenes.empty() || model_.defaultScene > 0)
            file_.root.fail(fmt::format("scene {} does not exist; the file has {}", scene,
                                        model_.scenes.size()));
        std::vector<bool> is_child(model_.nodes.size(), false);
        for (const tinygltf::Node& node : model_.nodes)
            for (const int child : node.children)
                if (child >= 0 && child < int(is_child.size())) is_child[child] = true;
        std::vector<int> roots;
        for (int i = 0; i < int(is_child.size()); ++i)
            if (!is_child[i]) roots.push_back(i);
        return roots;
    }

    // Depth first, in file order; a stack of our own, since a file may nest nodes as deep as it
    // likes.
    void read_nodes() {
        struct Visit {
            int node;
            Transform parent;
        };
        std::vector<Visit> stack;
        const auto push = [&](const std::vector<int>& nodes, const Transform& parent) {
            for (auto node = nodes.rbegin(); node != nodes.rend(); ++node)
                stack.push_back({*node, parent});
        };
        push(roots(), {});
        while (!stack.empty()) {
            const Visit visit = stack.back();
            stack.pop_back();
            if (visit.node < 0 || visit.node >= int(model_.nodes.size()))
                file_.root.at("nodes").fail(fmt::format("node {} does not exist; the file has {}",
                                                        visit.node, model_.nodes.size()));
            if (visited_[visit.node])
                file_.json("nodes", visit.node)
                    .fail("this node is the child of two nodes or of itself; "
                          "nodes must form a tree");
            visited_[visit.node] = true;
            const tinygltf::Node& node = model_.nodes[visit.node];
            const Transform to_world = visit.parent * transform_of(node);
            if (node.mesh >= int(model_.meshes.size()))
                file_.json("nodes", visit.node)
                    .fail(fmt::format("mesh {} does not exist; the file has {}", node.mesh,
                                      model_.meshes.size()));
            if (node.mesh >= 0)
                for (const tinygltf::Primitive& primitive : model_.meshes[node.mesh].primitives)
                    read_primitive(primitive, node.mesh, to_world);
            push(node.children, to_world);
        }
    }

    void read_primitive(const tinygltf::Primitive& primitive, int mesh, const Transform& to_world) {
        const int mode = primitive.mode;
        if (mode != TINYGLTF_MODE_TRIANGLES && mode != TINYGLTF_MODE_TRIANGLE_STRIP &&
            mode != TINYGLTF_MODE_TRIANGLE_FAN)
            return mesh_.warnings.push_back(fmt::format(
                "{}: points and lines of mesh {} have no surface and are left out", name_, mesh));
        const int material = primitive.material;
        if (material >= int(model_.materials.size()))
            fail_in_mesh(mesh, fmt::format("material {} does not exist; the file has {}", material,
                                           model_.materials.size()));

        const auto positions = attribute(primitive, "POSITION", 3, mesh);
        if (!positions) fail_in_mesh(mesh, "expected an attribute POSITION, found none");
        const auto normals = attribute(primitive, "NORMAL", 3, mesh);
        const int set =
            material < 0
                ? 0
                : model_.materials[material].pbrMetallicRoughness.baseColorTexture.texCoord;
        const auto uvs = attribute(primitive, fmt::format("TEXCOORD_{}", set), 2, mesh);
        for (const auto* other : {&normals, &uvs})
            if (*other && (*other)->count() != positions->count())
                fail_in_mesh(
                    mesh,
                    fmt::format(
                        "expected as many normals and texture coordinates as positions, found "
                        "{} and {}",
                        (*other)->count(), positions->count()));

        const int base = int(mesh_.positions.size());
        const std::vector<int> corners = indices(primitive, positions->count(), mesh);
        if (mesh_.positions.size() + std::size_t(positions->count()) > max_triangles ||
            mesh_.triangles.size() + corners.size() > max_triangles)
            fail_in_mesh(
                mesh, fmt::format(
                          "the file has more than {} triangles or vertices, nodes expanded; use a "
                          "smaller mesh",
                          max_triangles));
        const int base_normal = int(mesh_.normals.size()), base_uv = int(mesh_.uvs.size());
        const glm::dmat3 normal_matrix = glm::transpose(glm::inverse(to_world.linear));
        for (int i = 0; i < positions->count(); ++i) {
            mesh_.positions.push_back(to_world.point(positions->vec3(i)));
            if (normals) mesh_.normals.push_back(normal_matrix * normals->vec3(i));
            if (uvs)
                mesh_.uvs.emplace_back(uvs->vec2(i).x, 1 - uvs->vec2(i).y); // glTF's v points down
        }
        for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
            MeshTriangle triangle;
            triangle.material = material;
            for (int k = 0; k < 3; ++k) { // a mirrored node turns its triangles over
                const int corner =
                    corners[i + std::size_t(k > 0 && to_world.mirrors() ? 3 - k : k)];
                triangle.position[k] = base + corner;
                if (normals) triangle.normal[k] = base_normal + corner;
                if (uvs) triangle.uv[k] = base_uv + corner;
            }
            mesh_.triangles.push_back(triangle);
        }
    }

    [[noreturn]] void fail_in_mesh(int mesh, const std::string& what) const {
        file_.json("meshes", mesh).fail(what);
    }

    std::optional<GltfElements> attribute(const tinygltf::Primitive& primitive,
                                          const std::string& name, int components, int mesh) const {
        const auto found = primitive.attributes.find(name);
        if (found == primitive.attributes.end()) return std::nullopt;
        const GltfElements elements = accessor(found->second, name, mesh);
        if (elements.components() != components)
            fail_in_mesh(mesh, fmt::format("expected {} of {} components, found {}", name,
                                           components, elements.components()));
        return elements;
    }

    GltfElements accessor(int index, const std::string& of, int mesh) const {
        if (index < 0 || index >= int(model_.accessors.size()))
            fail_in_mesh(mesh, fmt::format("the accessor {} of {} does not exist; the file has {}",
                                           index, of, model_.accessors.size()));
        return GltfElements(file_, index);
    }

    // Three vertices per triangle, from a list, a strip or a fan, indexed or not.
    std::vector<int> indices(const tinygltf::Primitive& primitive, int vertices, int mesh) const {
        std::vector<int> list;
        if (primitive.indices < 0) {
            for (int i = 0; i < vertices; ++i) list.push_back(i);
        } else {
            const GltfElements elements = accessor(primitive.indices, "indices", mesh);
            if (elements.components() != 1 || !elements.is_unsigned_integer())
                file_.json("accessors", primitive.indices)
                    .fail("expected indices of type SCALAR with an "
                          "unsigned integer componentType");
            for (int i = 0; i < elements.count(); ++i) {
                const double index = elements(i, 0);
                if (index >= vertices)
                    file_.json("accessors", primitive.indices)
                        .fail(fmt::format(
                            "index {} is {}, but the primitive has {} vertices; the file is "
                            "damaged, export it again",
                            i, index, vertices));
                list.push_back(int(index));
            }
        }
        if (primitive.mode == TINYGLTF_MODE_TRIANGLES) {
            if (list.size() % 3 != 0)
                fail_in_mesh(mesh,
                             fmt::format("expected three vertices per triangle, found {} in all",
                                         list.size()));
            return list;
        }
        std::vector<int> triangles;
        const bool fan = primitive.mode == TINYGLTF_MODE_TRIANGLE_FAN;
        for (std::size_t i = 0; i + 2 < list.size(); ++i) {
            // A strip's odd triangles list their vertices the other way round (section 3.7.2.1).
            const std::size_t odd = i & 1;
            if (fan) triangles.insert(triangles.end(), {list[i + 1], list[i + 2], list[0]});
            if (!fan)
                triangles.insert(triangles.end(), {list[i], list[i + 1 + odd], list[i + 2 - odd]});
        }
        return triangles;
    }

    const GltfFile& file_;
    const tinygltf::Model& model_;
    const std::string& name_;
    const ReadNamedFile& read_;
    Mesh mesh_;
    std::vector<bool> visited_;
    std::vector<int> picture_of_image_;
};

} // namespace

Mesh parse_gltf(std::string_view bytes, const std::string& name, const ReadNamedFile& read) {
    const bool binary = bytes.starts_with("glTF");
    const std::string_view text = binary ? json_chunk(bytes, name) : bytes;
    const JsonDocument document = parse_json(text, binary ? name + " (its JSON chunk)" : name);
    const Node root(document);
    root.at("asset").at("version").string();
    check_extensions(root);
    check_buffer_views(root);
    const tinygltf::Model model = load_model(bytes, binary, name, read);
    const GltfFile file{model, root};
    return GltfReader(file, name, read).read();
}

} // namespace raylab
