// From a scene file to a validated Scene.
#pragma once

#include "common/load/scene_error.h"
#include "common/scene/scene.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace raylab {

// Reads a scene and every file it names. Throws SceneError, whose what() says which file, line and
// column are wrong, what was expected there and what to do. What is legal but probably not meant
// ends up in Scene::warnings.
Scene load_scene(const std::filesystem::path& file);

// The same for a scene already in memory; `where` is the name for messages, and files are looked up
// relative to its folder.
Scene parse_scene(std::string_view text, const std::filesystem::path& where);

// The file of a scene given by name ("cornell": scenes/cornell.json) or by path ("my/room.json").
// Throws SceneError with the nearest name if there is no such scene.
std::filesystem::path find_scene(const std::string& name_or_path);

// The names of the scenes that come with raylab, sorted.
std::vector<std::string> bundled_scenes();

} // namespace raylab
