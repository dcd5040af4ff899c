// A mesh file as a scene that a person then edits.
#pragma once

#include "common/load/mesh.h"

#include <string>
#include <vector>

namespace raylab::app {

struct ImportedScene {
    std::string text; // of a scene file
    // What was chosen, approximated or left out: a sentence for each, without a full stop.
    std::vector<std::string> notes;
};

// The camera, the lights and the materials of the mesh are written into the scene, a line for each.
// Triangles and pictures stay in the mesh file, which the scene calls `file`, relative to its own
// folder. `title` is the scene's title. A material stays in the mesh file if a scene file cannot
// describe it: a material with a picture, or glass that glows. Lengths are the file's. Throws
// UsageError for a mesh without a finite triangle.
ImportedScene import_scene(const Mesh& mesh, const std::string& file, const std::string& title);

} // namespace raylab::app
