// Every key of a scene file, block by block: the only list, used by the loader and checked against
// scenes/scene.schema.json.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace raylab {

// Block ("scene", "camera", "material glass", "shape sphere", "light point", ...) -> its keys.
const std::map<std::string, std::vector<std::string>>& scene_keys();

} // namespace raylab
