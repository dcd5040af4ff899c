// What the tests of the loader share: a small valid scene to break, and a folder for its files.
#pragma once

#include "common/cli/tests/temporary_folder.h"
#include "common/load/load.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

namespace raylab {

// A scene that loads without a warning; one line for each section.
inline const std::string good_scene = R"({
  "version": 1,
  "camera": {"position": [0, 0, 5], "look_at": [0, 0, 0], "up": [0, 1, 0], "vfov_deg": 40},
  "film": {"width": 8, "height": 4},
  "render": {"spp": 4, "max_depth": 8},
  "materials": {
    "white": {"kind": "diffuse", "reflectance": [0.5, 0.5, 0.5]},
    "lamp": {"kind": "diffuse", "reflectance": [0, 0, 0], "emission": [1, 1, 1]}
  },
  "shapes": [
    {"kind": "sphere", "center": [0, 0, 0], "radius": 1, "material": "white"},
    {"kind": "quad", "vertices": [[0, 3, 0], [1, 3, 0], [1, 3, 1], [0, 3, 1]], "material": "lamp"}
  ],
  "lights": [{"kind": "point", "position": [0, 5, 0], "intensity": [1, 1, 1]}]
})";

// The scene with the first `from` replaced; `from` must be there.
std::string with(std::string scene, const std::string& from, const std::string& to);

// The good scene with these shapes (JSON, without the brackets) instead of its own.
std::string scene_of_shapes(const std::string& shapes);

// A scene text as if it were s.json in the folder.
Scene load(const std::string& text, const TemporaryFolder& folder);
Scene load(const std::string& text);

// The message of the SceneError that f throws, the folder's name taken out; fails if f throws none.
template <class F> std::string error_of(F&& f) {
    try {
        f();
    } catch (const SceneError& error) {
        return error.what();
    }
    ADD_FAILURE() << "no SceneError was thrown";
    return "";
}

// Bytes of small files, made in the test.
std::string little_endian(std::initializer_list<float> values);
std::string png(int width, int height, const std::string& texels,
                int channels = 3); // 8 bits, stored uncompressed; 4: with alpha
std::string hdr(int width, int height, const std::string& rgbe);

} // namespace raylab
