// Every key of a scene file, object by object. This is the only list: the loader uses it, and a
// test compares it with scenes/scene.schema.json.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace raylab {

// Object ("scene", "camera", "material glass", "shape sphere", "light point", ...) -> its keys.
const std::map<std::string, std::vector<std::string>>& scene_keys();

} // namespace raylab
