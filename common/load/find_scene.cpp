// Scenes by name.
#include "common/load/load.h"
#include "common/load/suggest.h"

#include <algorithm>

namespace raylab {

namespace fs = std::filesystem;

std::vector<std::string> bundled_scenes() {
    std::vector<std::string> names;
    std::error_code error; // a missing folder has no scenes
    for (const fs::directory_entry& entry : fs::directory_iterator(RAYLAB_SCENES_DIR, error))
        if (entry.path().extension() == ".json" && entry.path().stem().extension() != ".schema")
            names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

fs::path find_scene(const std::string& name_or_path) {
    const std::vector<std::string> names = bundled_scenes();
    if (std::find(names.begin(), names.end(), name_or_path) != names.end())
        return fs::path(RAYLAB_SCENES_DIR) / (name_or_path + ".json");
    std::error_code error;
    if (fs::is_regular_file(name_or_path, error)) return name_or_path;
    const std::string stem = fs::path(name_or_path).stem().string();
    throw SceneError("there is no scene " + name_or_path + did_you_mean(stem, names) +
                     "; give the path of a scene file or " +
                     (names.empty() ? "a bundled scene's name" : "one of " + one_of(names)));
}

} // namespace raylab
