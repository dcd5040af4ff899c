// The cameras of a glTF file (glTF 2.0, section 3.10): each looks along -z of its node, with y up.
#pragma once

#include "common/load/gltf_losses.h"
#include "common/load/mesh.h"
#include "common/load/node.h"
#include "common/load/transform.h"

#include <optional>

namespace raylab {

// The node's camera, placed in the world. Nothing if the node has no camera, or one of a kind that
// raylab does not read: that is added to the losses. root: the whole file. Throws SceneError.
std::optional<MeshCamera> read_gltf_camera(const Node& root, const Node& node,
                                           const Transform& to_world, GltfLosses& losses);

} // namespace raylab
