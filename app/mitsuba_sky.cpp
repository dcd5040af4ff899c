#include "app/mitsuba_sky.h"

#include <algorithm>

namespace raylab::app::mitsuba {

namespace {

constexpr int sky_columns = 8, sky_rows = 32; // for each texel of ours

} // namespace

// The sky for a renderer that interpolates linearly between samples at (column + 1/2) / width
// and row / (height - 1). Edges between our texels lie half way between two columns, and on
// rows, which take the mean of both sides: so each ramp keeps the integral of the step.
Image fine_sky(const Scene& scene) {
    const int w = scene.environment_width, h = scene.environment_height;
    Image image{sky_columns * w, sky_rows * h + 1, {}, {}, {}};
    for (int y = 0; y < image.height; ++y) {
        const int below = std::min(y / sky_rows, h - 1);
        const int above = y % sky_rows == 0 ? std::max(y / sky_rows - 1, 0) : below;
        for (int x = 0; x < image.width; ++x)
            image.mean.push_back(scene.environment_radiance * 0.5f *
                                 (scene.environment_map[above * w + x / sky_columns] +
                                  scene.environment_map[below * w + x / sky_columns]));
    }
    return image;
}

} // namespace raylab::app::mitsuba
