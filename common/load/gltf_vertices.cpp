// The vertices of one primitive of a glTF mesh.
#include "common/load/gltf_vertices.h"

#include <fmt/format.h>

#include <algorithm>

namespace raylab {
namespace {

class PrimitiveReader {
  public:
    PrimitiveReader(const GltfFile& file, int mesh, const tinygltf::Primitive& primitive)
        : file_(file), mesh_(mesh), primitive_(primitive) {}

    // `what` is one element of it, for errors.
    std::optional<GltfElements> attribute(const std::string& name, const std::string& what,
                                          std::initializer_list<int> components) const {
        const auto found = primitive_.attributes.find(name);
        if (found == primitive_.attributes.end()) return std::nullopt;
        return elements(found->second, name, what, components);
    }

    GltfElements elements(int index, const std::string& name, const std::string& what,
                          std::initializer_list<int> components) const {
        const GltfElements elements = accessor(index, name);
        if (std::find(components.begin(), components.end(), elements.components()) ==
            components.end())
            fail(fmt::format("expected {} of {} components, found {}", name, *components.begin(),
                             elements.components()));
        elements.expect_finite(file_, what);
        return elements;
    }

    GltfElements accessor(int index, const std::string& of) const {
        const auto count = int(file_.model.accessors.size());
        if (index < 0 || index >= count)
            fail(fmt::format("the accessor {} of {} does not exist; the file has {}", index, of,
                             count));
        return GltfElements(file_, index);
    }

    // Three vertices per triangle, from a list, a strip or a fan, indexed or not.
    std::vector<int> corners(int vertices) const;

    [[noreturn]] void fail(const std::string& what) const {
        file_.json("meshes", mesh_).fail(what);
    }

  private:
    std::vector<int> indices(int vertices) const;

    const GltfFile& file_;
    int mesh_;
    const tinygltf::Primitive& primitive_;
};

std::vector<int> PrimitiveReader::indices(int vertices) const {
    std::vector<int> list;
    if (primitive_.indices < 0) {
        for (int i = 0; i < vertices; ++i) list.push_back(i);
        return list;
    }
    const GltfElements elements = accessor(primitive_.indices, "indices");
    if (elements.components() != 1 || !elements.is_unsigned_integer())
        file_.json("accessors", primitive_.indices)
            .fail("expected indices of type SCALAR with an "
                  "unsigned integer componentType");
    for (int i = 0; i < elements.count(); ++i) {
        const double index = elements(i, 0);
        if (index >= vertices)
            file_.json("accessors", primitive_.indices)
                .fail(fmt::format("index {} is {}, but the primitive has {} vertices; the file is "
                                  "damaged, export it again",
                                  i, index, vertices));
        list.push_back(int(index));
    }
    return list;
}

std::vector<int> PrimitiveReader::corners(int vertices) const {
    const std::vector<int> list = indices(vertices);
    if (primitive_.mode == TINYGLTF_MODE_TRIANGLES) {
        if (list.size() % 3 != 0)
            fail(fmt::format("expected three vertices per triangle, found {} in all", list.size()));
        return list;
    }
    std::vector<int> triangles;
    const bool fan = primitive_.mode == TINYGLTF_MODE_TRIANGLE_FAN;
    for (std::size_t i = 0; i + 2 < list.size(); ++i) {
        // A strip's odd triangles list their vertices the other way round (section 3.7.2.1).
        const std::size_t odd = i & 1;
        if (fan) triangles.insert(triangles.end(), {list[i + 1], list[i + 2], list[0]});
        if (!fan)
            triangles.insert(triangles.end(), {list[i], list[i + 1 + odd], list[i + 2 - odd]});
    }
    return triangles;
}

Vec3 colour(const GltfElements& colours, int i, bool& above_one) {
    Vec3 colour = colours.vec3(i);
    for (int c = 0; c < 3; ++c) {
        above_one |= colour[c] > 1;
        colour[c] = std::clamp(colour[c], 0.0f, 1.0f);
    }
    return colour;
}

} // namespace

GltfVertices read_gltf_vertices(const GltfFile& file, int mesh,
                                const tinygltf::Primitive& primitive,
                                const std::vector<double>& weights, const std::set<int>& uv_sets,
                                GltfLosses& losses) {
    const PrimitiveReader reader(file, mesh, primitive);
    GltfVertices vertices;
    const auto positions = reader.attribute("POSITION", "position", {3});
    if (!positions) reader.fail("expected an attribute POSITION, found none");
    const int count = positions->count();
    const auto expect_as_many = [&](const GltfElements& elements, const std::string& name) {
        if (elements.count() != count)
            reader.fail(fmt::format("expected as many elements of {} as positions, found {} and {}",
                                    name, elements.count(), count));
    };
    for (int i = 0; i < count; ++i) vertices.positions.push_back(positions->vec3(i));
    if (const auto normals = reader.attribute("NORMAL", "normal", {3})) {
        expect_as_many(*normals, "NORMAL");
        for (int i = 0; i < count; ++i) vertices.normals.push_back(normals->vec3(i));
    }
    if (const auto colours = reader.attribute("COLOR_0", "colour", {3, 4})) {
        expect_as_many(*colours, "COLOR_0");
        bool above_one = false;
        for (int i = 0; i < count; ++i) vertices.colours.push_back(colour(*colours, i, above_one));
        if (above_one) losses.add("vertex colours above 1", "primitive");
    }
    for (const int set : uv_sets) {
        const std::string name = fmt::format("TEXCOORD_{}", set);
        const auto uvs = reader.attribute(name, "texture coordinate", {2});
        if (!uvs) continue;
        expect_as_many(*uvs, name);
        for (int i = 0; i < count; ++i) vertices.uvs[set].push_back(uvs->vec2(i));
    }
    for (std::size_t t = 0; t < std::min(primitive.targets.size(), weights.size()); ++t) {
        const auto add = [&](const std::string& name, std::vector<DVec3>& to) {
            const auto found = primitive.targets[t].find(name);
            if (weights[t] == 0 || to.empty() || found == primitive.targets[t].end()) return;
            const GltfElements delta = reader.elements(found->second, name, "displacement", {3});
            expect_as_many(delta, "the morph target's " + name);
            for (int i = 0; i < count; ++i) to[std::size_t(i)] += weights[t] * delta.vec3(i);
        };
        add("POSITION", vertices.positions);
        add("NORMAL", vertices.normals);
    }
    vertices.corners = reader.corners(count);
    return vertices;
}

std::vector<Transform> read_gltf_binding(const GltfFile& file, int mesh,
                                         const tinygltf::Primitive& primitive, int vertices,
                                         const std::vector<Transform>& joints) {
    const PrimitiveReader reader(file, mesh, primitive);
    std::vector<Transform> bound;
    std::vector<double> total;
    for (int set = 0;; ++set) {
        const std::string joints_name = fmt::format("JOINTS_{}", set),
                          weights_name = fmt::format("WEIGHTS_{}", set);
        const auto indices = reader.attribute(joints_name, "joint", {4});
        if (!indices) break;
        const auto weights = reader.attribute(weights_name, "weight", {4});
        if (!weights)
            reader.fail(
                fmt::format("expected {} beside {}, found none", weights_name, joints_name));
        if (indices->count() != vertices || weights->count() != vertices)
            reader.fail(
                fmt::format("expected as many joints and weights as positions, found {}, {} "
                            "and {}",
                            indices->count(), weights->count(), vertices));
        bound.resize(std::size_t(vertices), {glm::dmat3(0), DVec3(0)});
        total.resize(std::size_t(vertices), 0);
        for (int i = 0; i < vertices; ++i)
            for (int k = 0; k < 4; ++k) {
                const double weight = (*weights)(i, k), joint = (*indices)(i, k);
                if (weight == 0) continue;
                if (!(joint >= 0 && joint < double(joints.size())))
                    reader.fail(fmt::format("vertex {} is bound to joint {}, and its skin has {}",
                                            i, joint, joints.size()));
                const Transform& to = joints[std::size_t(joint)];
                bound[std::size_t(i)].linear += weight * to.linear;
                bound[std::size_t(i)].translation += weight * to.translation;
                total[std::size_t(i)] += weight;
            }
    }
    for (std::size_t i = 0; i < bound.size(); ++i) {
        if (total[i] == 0) { // no weights: bound to the first joint, as in viewers
            if (joints.empty()) reader.fail("the primitive is bound to a skin without joints");
            bound[i] = joints[0];
        } else { // weights that do not add up to 1 would scale the mesh
            bound[i].linear /= total[i];
            bound[i].translation /= total[i];
        }
    }
    return bound;
}

} // namespace raylab
