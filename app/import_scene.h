// A mesh file as a scene that a person then edits.
#pragma once

#include "common/load/mesh.h"

#include <string>
#include <vector>

namespace raylab::app {

struct ImportedScene {
    std::string text; // of a scene file
    // What was chosen, approximated or left out, a sentence each, without a full stop.
    std::vector<std::string> notes;
};

// Camera, lights and materials of the mesh are written out, a line each; triangles and pictures
// stay in the file, which the scene calls `file`, relative to its own folder. `title` is the
// scene's. A material stays the file's own where a scene cannot say it: with a picture, or glass
// that glows. Lengths are the file's. Throws UsageError for a mesh without a finite triangle.
ImportedScene import_scene(const Mesh& mesh, const std::string& file, const std::string& title);

} // namespace raylab::app
