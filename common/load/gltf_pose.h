// Where the parts of a glTF file stand: nodes, instances, skins and morph targets in the rest pose.
// glTF 2.0, sections 3.5.3 and 3.7; the extension EXT_mesh_gpu_instancing.
#pragma once

#include "common/load/gltf_data.h"
#include "common/load/gltf_losses.h"
#include "common/load/transform.h"

#include <optional>
#include <vector>

namespace raylab {

// The nodes of the file's scene.
struct GltfNodes {
    std::vector<int> order;                         // depth first, in file order
    std::vector<std::optional<Transform>> to_world; // of each node of the file; nothing: not in it

    // Throws SceneError unless the scene's nodes form trees.
    explicit GltfNodes(const GltfFile& file);
};

// Where the node's mesh stands in the world, once, or once for each instance.
std::vector<Transform> instances_of(const GltfFile& file, const Node& node,
                                    const Transform& to_world);

// World transform of each of a skin's joints, which bound vertices follow.
std::vector<Transform> joints_of(const GltfFile& file, const GltfNodes& nodes, int skin);

} // namespace raylab
