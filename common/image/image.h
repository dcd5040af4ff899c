// Image: what every renderer produces and every judge reads.
#pragma once

#include "common/math/vec.h"

#include <cstdint>
#include <string>
#include <vector>

namespace raylab {

// Where an image came from. Empty strings and zeros: unknown.
struct Provenance {
    std::string scene;      // scene name
    std::string scene_hash; // 16 hex digits, see Scene::hash
    std::string integrator; // "path" or "whitted"
    std::string renderer;   // "02_iterative", or another program's name
    std::uint32_t seed = 0;
    int spp = 0;
    int max_depth = 0;
};

// Linear radiance, RGB, row by row, top row first.
struct Image {
    int width = 0, height = 0;
    std::vector<Vec3> mean; // width * height
    // Standard error of the mean, width * height; infinite where one sample cannot tell; empty:
    // unknown. Not its square: float holds no variance of radiance above 1e19 or below 1e-23.
    std::vector<Vec3> error;
    Provenance provenance;

    std::size_t pixels() const { return static_cast<std::size_t>(width) * height; }
    const Vec3& at(int x, int y) const { return mean[static_cast<std::size_t>(y) * width + x]; }
    DVec3 variance(std::size_t i) const { return DVec3(error[i]) * DVec3(error[i]); } // of the mean
};

} // namespace raylab
