// Image files as linear RGB: textures and environment maps.
#pragma once

#include "common/math/vec.h"

#include <string>
#include <string_view>
#include <vector>

namespace raylab {

struct Picture {
    int width = 0, height = 0;
    std::vector<Vec3> texels;   // linear RGB, row by row, top row first; all finite, >= 0
    std::vector<float> alpha{}; // in [0, 1], as many; none: 1 everywhere
};

// Sizes beyond these are errors.
constexpr int max_picture_side = 16384;
constexpr int max_picture_texels = 1 << 25; // 384 MiB as float

// Decodes PNG or JPEG (both sRGB) or Radiance HDR (linear); docs/formats.md says what of them.
// `name` is for messages. Throws SceneError: unknown format, too large, damaged, or ending too
// early.
Picture decode_picture(std::string_view bytes, const std::string& name);

} // namespace raylab
