// The vertices of one primitive of a glTF mesh, every number checked, morph targets applied.
// glTF 2.0, section 3.7.2.
#pragma once

#include "common/load/gltf_data.h"
#include "common/load/gltf_losses.h"
#include "common/load/transform.h"

#include <map>
#include <set>
#include <vector>

namespace raylab {

struct GltfVertices {
    std::vector<DVec3> positions;
    std::vector<DVec3> normals;           // as many, or none
    std::vector<Vec3> colours;            // COLOR_0, linear, in [0, 1]; as many, or none
    std::map<int, std::vector<Vec2>> uvs; // by set; v down; as many each
    std::vector<int> corners;             // three a triangle
};

// uv_sets: the texture coordinate sets to read, where the file has them. Morph weights: those of
// the node, else the mesh's (section 3.7.2.2).
GltfVertices read_gltf_vertices(const GltfFile& file, int mesh,
                                const tinygltf::Primitive& primitive,
                                const std::vector<double>& weights, const std::set<int>& uv_sets,
                                GltfLosses& losses);

// Where joints take each vertex of the primitive: sum of weight * joint (section 3.7.3.3). Empty if
// the primitive is not bound.
std::vector<Transform> read_gltf_binding(const GltfFile& file, int mesh,
                                         const tinygltf::Primitive& primitive, int vertices,
                                         const std::vector<Transform>& joints);

} // namespace raylab
