// Lights of a glTF file (KHR_lights_punctual).
#pragma once

#include "common/load/gltf_losses.h"
#include "common/load/mesh.h"
#include "common/load/node.h"
#include "common/load/transform.h"

#include <optional>

namespace raylab {

// The light of the node, placed by the node's transform: a point light, or nothing. Lights of other
// kinds, and ranges, are counted as losses. root: the file. Throws SceneError.
std::optional<MeshLight> read_gltf_light(const Node& root, const Node& node,
                                         const Transform& to_world, GltfLosses& losses);

} // namespace raylab
