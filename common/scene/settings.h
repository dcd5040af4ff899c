// How to render: the `render` block of a scene file, with the command line's changes applied.
#pragma once

#include "common/sampling/sampler_kind.h"

#include <cstdint>
#include <optional>
#include <string>

namespace raylab {

enum class Integrator : int { whitted, path };

// How direct light is found: by sampling lights, by letting BSDF samples hit them, or by both with
// multiple importance sampling. All three have the same mean.
enum class DirectLight : int { mis, light, bsdf };

struct RenderSettings {
    Integrator integrator = Integrator::path;
    // Surfaces a path may touch: with max_depth 1 only what the camera sees glows. In [1, 10000];
    // whitted at most 24, since each glass hit doubles its rays.
    int max_depth = 8;
    int spp = 64; // samples a pixel
    std::uint32_t seed = 1;
    SamplerKind sampler = SamplerKind::sobol;
    DirectLight direct_light = DirectLight::mis;
    bool roulette = true; // Russian roulette from the second surface on
    bool jitter = true;   // camera rays go through random points of their pixel; else its middle
};

constexpr int max_film_side = 16384; // pixels; so a film has at most 2^28 of them
constexpr int max_samples = 1 << 20; // a pixel
constexpr int max_path_depth = 10000;
constexpr int max_whitted_depth = 24;

struct SettingsProblem {
    std::string key;  // of the `render` or `film` block: "spp", "max_depth", "width", "height"
    std::string what; // "expected ..., found ...; what to do"
};

// The first thing that is wrong with the settings and a film of width * height pixels, or nothing.
// For scene files and for command lines alike.
std::optional<SettingsProblem> problem_with(const RenderSettings& settings, int width, int height);

} // namespace raylab
