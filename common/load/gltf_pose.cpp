// Where the parts of a glTF file stand.
#include "common/load/gltf_pose.h"

#include <fmt/format.h>

#include <cmath>

namespace raylab {
namespace {

// The quaternion (x, y, z, w) as a matrix.
glm::dmat3 turned(DVec3 v, double w) {
    const double sine = std::sqrt(dot(v, v)); // of half the angle
    return sine > 0 ? rotation(v / sine, 2 * std::atan2(sine, w)) : glm::dmat3(1);
}

Transform from_matrix(const glm::dmat4& m) { return {glm::dmat3(m), DVec3(m[3])}; }

Transform transform_of(const tinygltf::Node& node) {
    Transform transform;
    if (node.matrix.size() == 16) { // column by column
        glm::dmat4 m;
        for (int i = 0; i < 16; ++i) m[i / 4][i % 4] = node.matrix[std::size_t(i)];
        return from_matrix(m);
    }
    if (node.rotation.size() == 4)
        transform.linear =
            turned(DVec3(node.rotation[0], node.rotation[1], node.rotation[2]), node.rotation[3]);
    if (node.scale.size() == 3)
        for (int axis = 0; axis < 3; ++axis) transform.linear[axis] *= node.scale[axis];
    if (node.translation.size() == 3)
        transform.translation =
            DVec3(node.translation[0], node.translation[1], node.translation[2]);
    return transform;
}

// The nodes of the default scene; without one, of the first scene; without scenes, all nodes that
// have no parent.
std::vector<int> roots(const GltfFile& file) {
    const tinygltf::Model& model = file.model;
    const int scene = model.defaultScene < 0 ? 0 : model.defaultScene;
    if (scene < int(model.scenes.size())) return model.scenes[scene].nodes;
    if (!model.scenes.empty() || model.defaultScene > 0)
        file.root.fail(
            fmt::format("scene {} does not exist; the file has {}", scene, model.scenes.size()));
    std::vector<bool> is_child(model.nodes.size(), false);
    for (const tinygltf::Node& node : model.nodes)
        for (const int child : node.children)
            if (child >= 0 && child < int(is_child.size())) is_child[child] = true;
    std::vector<int> roots;
    for (int i = 0; i < int(is_child.size()); ++i)
        if (!is_child[i]) roots.push_back(i);
    return roots;
}

GltfElements accessor(const GltfFile& file, const Node& index, int components) {
    const int i = index.integer();
    if (i < 0 || i >= int(file.model.accessors.size()))
        index.fail(fmt::format("accessor {} does not exist; the file has {}", i,
                               file.model.accessors.size()));
    const GltfElements elements(file, i);
    elements.expect_finite(file, "element");
    if (elements.components() != components)
        index.fail(fmt::format("expected an accessor of {} components, found {}", components,
                               elements.components()));
    return elements;
}

} // namespace

// A stack of our own, since a file may nest nodes as deep as it likes.
GltfNodes::GltfNodes(const GltfFile& file) : to_world(file.model.nodes.size()) {
    struct Visit {
        int node;
        Transform parent;
    };
    std::vector<Visit> stack;
    const auto push = [&](const std::vector<int>& nodes, const Transform& parent) {
        for (auto node = nodes.rbegin(); node != nodes.rend(); ++node)
            stack.push_back({*node, parent});
    };
    push(roots(file), {});
    while (!stack.empty()) {
        const Visit visit = stack.back();
        stack.pop_back();
        if (visit.node < 0 || visit.node >= int(to_world.size()))
            file.root.at("nodes").fail(fmt::format("node {} does not exist; the file has {}",
                                                   visit.node, to_world.size()));
        if (to_world[visit.node])
            file.json("nodes", visit.node)
                .fail("this node is the child of two nodes or of itself; nodes must form a tree");
        const tinygltf::Node& node = file.model.nodes[visit.node];
        to_world[visit.node] = visit.parent * transform_of(node);
        order.push_back(visit.node);
        push(node.children, *to_world[visit.node]);
    }
}

std::vector<Transform> instances_of(const GltfFile& file, const Node& node,
                                    const Transform& to_world) {
    const auto extensions = node.find("extensions");
    const auto instancing =
        extensions ? extensions->find("EXT_mesh_gpu_instancing") : std::optional<Node>();
    if (!instancing) return {to_world};
    const Node attributes = instancing->at("attributes");
    std::optional<GltfElements> translation, turn, scale;
    if (const auto a = attributes.find("TRANSLATION")) translation = accessor(file, *a, 3);
    if (const auto a = attributes.find("ROTATION")) turn = accessor(file, *a, 4);
    if (const auto a = attributes.find("SCALE")) scale = accessor(file, *a, 3);
    int count = -1;
    for (const auto* part : {&translation, &turn, &scale})
        if (*part) {
            if (count >= 0 && (*part)->count() != count)
                attributes.fail(fmt::format(
                    "expected accessors of the same length, found {} and {}; export the file again",
                    count, (*part)->count()));
            count = (*part)->count();
        }
    if (count < 0) attributes.fail("expected TRANSLATION, ROTATION or SCALE, found none of them");
    std::vector<Transform> instances;
    for (int i = 0; i < count; ++i) {
        Transform instance;
        if (turn) instance.linear = turned(turn->vec3(i), (*turn)(i, 3));
        if (scale)
            for (int axis = 0; axis < 3; ++axis) instance.linear[axis] *= (*scale)(i, axis);
        if (translation) instance.translation = translation->vec3(i);
        instances.push_back(to_world * instance);
    }
    return instances;
}

// world = joint's world * inverse bind matrix (section 3.7.3.3).
std::vector<Transform> joints_of(const GltfFile& file, const GltfNodes& nodes, int index) {
    const Node skin = file.json("skins", index);
    if (!skin.has("joints"))
        skin.fail("expected joints: a skin is a list of the nodes that move it; export the file "
                  "again, or without skins");
    const std::vector<Node> joints = skin.at("joints").elements();
    std::optional<GltfElements> inverse_bind;
    if (const auto matrices = skin.find("inverseBindMatrices")) {
        inverse_bind = accessor(file, *matrices, 16);
        if (inverse_bind->count() < int(joints.size()))
            matrices->fail(fmt::format("expected a matrix for each of {} joints, found {}",
                                       joints.size(), inverse_bind->count()));
    }
    std::vector<Transform> result;
    for (const Node& joint : joints) {
        const int node = joint.integer();
        if (node < 0 || node >= int(nodes.to_world.size()) || !nodes.to_world[node])
            joint.fail(
                fmt::format("the joint {} is no node of the file's scene; export it again", node));
        Transform transform = *nodes.to_world[node];
        if (inverse_bind)
            transform = transform * from_matrix(inverse_bind->mat4(int(result.size())));
        result.push_back(transform);
    }
    return result;
}

} // namespace raylab
