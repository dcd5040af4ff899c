// Random numbers as a function, not as a state: u(seed, pixel, sample, dimension).
//
// No thread, slot or order enters, so every lab, machine and schedule traces the very same paths.
// Dimensions come in pairs; a fixed pair for each decision of each bounce keeps Sobol points
// well spread in that decision whatever happened before.
#pragma once

#include "common/math/vec.h"
#include "common/sampling/hash.h"
#include "common/sampling/sobol.h"
#include "common/scene/settings.h"

#include <cstdint>

namespace raylab {

struct Sampler {
    SamplerKind kind;
    std::uint32_t seed;
    std::uint32_t pixel;  // y * width + x
    std::uint32_t sample; // 0, 1, 2, ...

    // Two numbers in [0, 1), never 1. Sobol: the key chooses a sequence, the sample's number is the
    // place in it. Independent: the number is part of the key.
    HD Vec2 get_2d(std::uint32_t pair) const {
        const bool sobol = kind == SamplerKind::sobol;
        const Words key = pcg4d({seed, pixel, pair, sobol ? 0 : sample});
        return sobol ? owen_sobol_2d(sample, key) : Vec2(to_unit(key.x), to_unit(key.y));
    }
    HD float get_1d(std::uint32_t pair) const { return get_2d(pair).x; }
};

// The decisions of a path, in order: each takes one pair of dimensions.
namespace dimension {
constexpr std::uint32_t film = 0; // position in the pixel
constexpr std::uint32_t lens = 1; // position on the lens
constexpr std::uint32_t first_bounce = 2;
constexpr std::uint32_t per_bounce = 4;
// Within a bounce:
constexpr std::uint32_t light_point = 0;   // where on the light
constexpr std::uint32_t light_choice = 1;  // .x which light, .y unused
constexpr std::uint32_t direction = 2;     // the BSDF's direction
constexpr std::uint32_t lobe_roulette = 3; // .x which lobe, .y Russian roulette
} // namespace dimension

// Where in its pixel a camera ray goes through, in [0, 1)^2: anywhere, or always the middle.
HD Vec2 film_point(const RenderSettings& settings, const Sampler& sampler) {
    return settings.jitter ? sampler.get_2d(dimension::film) : Vec2(0.5f);
}

HD constexpr std::uint32_t bounce_dimension(std::uint32_t bounce, std::uint32_t decision) {
    return dimension::first_bounce + dimension::per_bounce * bounce + decision;
}

// Whitted's tracer sends a feeler to every light from every node of its ray tree: a pair of their
// own for each, far from the others by hashing.
HD std::uint32_t feeler_dimension(std::uint32_t node, int light) {
    return pcg4d({bounce_dimension(node, dimension::light_point), std::uint32_t(light), 0, 0}).x;
}

} // namespace raylab
