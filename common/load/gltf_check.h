// What can be said of a glTF file before its numbers are read: whether raylab can read it at all.
#pragma once

#include "common/load/node.h"

#include <string>
#include <string_view>

namespace raylab {

// The JSON text within a GLB file. Throws SceneError unless its chunks fill the file exactly, and
// for the container of glTF 1.0.
std::string_view json_chunk(std::string_view glb, const std::string& name);

// Throws SceneError unless the file is glTF 2.x and asks for no more than 2.0 (section 3.2).
void check_version(const Node& root);

// Throws SceneError if the file requires an extension that raylab lacks, or keeps its geometry in a
// compressed form only.
void check_extensions(const Node& root);

// Throws SceneError unless each buffer view lies within its buffer, as the JSON declares it.
// Before the library runs, which does not check the views that images use.
void check_buffer_views(const Node& root);

} // namespace raylab
