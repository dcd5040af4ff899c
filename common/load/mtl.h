// Wavefront MTL: the materials of an OBJ file.
#pragma once

#include "common/load/mesh.h"

#include <map>
#include <string>
#include <vector>

namespace raylab {

using MtlLibrary = std::map<std::string, MeshMaterial>;

// The materials of the files that an OBJ file's `mtllib` lines name, as near as raylab has them;
// their pictures are added to the mesh, and so is a warning for each file that cannot be read.
// `name` is the OBJ file's, for messages.
MtlLibrary read_mtl(const std::vector<std::string>& files, const std::string& name,
                    const ReadNamedFile& read, Mesh& mesh);

} // namespace raylab
