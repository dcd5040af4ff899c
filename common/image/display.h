// From radiance to what a screen shows and back: exposure in stops, then the sRGB curve
// (IEC 61966-2-1).
#pragma once

#include "common/math/index.h"
#include "common/math/numbers.h"
#include "common/math/vec.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace raylab {

inline float srgb_from_linear(float v) {
    return v <= 0.0031308f ? 12.92f * v : 1.055f * std::pow(v, 1 / 2.4f) - 0.055f;
}

inline float linear_from_srgb(double v) {
    return float(v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4));
}

// 8-bit R, G, B of a pixel multiplied by 2^exposure. What is no number shows in magenta.
inline std::array<std::uint8_t, 3> display_rgb8(Vec3 radiance, float exposure) {
    if (!is_finite(radiance)) return {255, 0, 255};
    std::array<std::uint8_t, 3> rgb{};
    for (int c = 0; c < 3; ++c) {
        const float v = clamp(radiance[c] * std::exp2(exposure), 0, 1);
        rgb[static_cast<std::size_t>(c)] =
            static_cast<std::uint8_t>(index_of(std::round(255 * srgb_from_linear(v)), 256));
    }
    return rgb;
}

} // namespace raylab
