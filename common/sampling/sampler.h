// Random numbers as a function, not as a state: u(seed, pixel, sample, dimension).
//
// The number does not depend on a thread, a slot or an order, so all labs and machines trace the
// same paths. Dimensions come in pairs. Each decision of each bounce has a pair of its own, so that
// Sobol points are spread well in that decision, whatever the path did before.
#pragma once

#include "common/math/vec.h"
#include "common/sampling/hash.h"
#include "common/sampling/path_stop.h"
#include "common/sampling/sampler_kind.h"
#include "common/sampling/sobol.h"

#include <cstdint>

namespace raylab {

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
// Two decisions determine most of a path's radiance: the point in the pixel, and the direction in
// which the path leaves the first surface. So their two pairs are one point in four dimensions.
constexpr std::uint32_t first_direction = first_bounce + direction;
} // namespace dimension

// What the decisions of one bounce need, in [0, 1).
struct BounceNumbers {
    Vec2 light_point;
    float light_choice;
    Vec2 direction;
    float lobe, roulette;
};

HD constexpr std::uint32_t bounce_dimension(std::uint32_t bounce, std::uint32_t decision) {
    return dimension::first_bounce + dimension::per_bounce * bounce + decision;
}

// The bounce that takes this pair; camera_ray_stop for those of the film and the lens.
HD constexpr int bounce_of(std::uint32_t pair) {
    return pair < dimension::first_bounce
               ? camera_ray_stop
               : static_cast<int>((pair - dimension::first_bounce) / dimension::per_bounce);
}

struct Sampler {
    SamplerKind kind;
    std::uint32_t seed;
    std::uint32_t pixel;  // y * width + x
    std::uint32_t sample; // 0, 1, 2, ...

    // Two numbers in [0, 1), never 1. Sobol: the key chooses a sequence, the sample's number is the
    // place in it. Independent: the number is part of the key.
    HD_HOT Vec2 get_2d(std::uint32_t pair) const {
        path_is_at(pixel, sample, bounce_of(pair));
        const bool sobol = kind == SamplerKind::sobol;
        const Words key = pcg4d({seed, pixel, pair, sobol ? 0 : sample});
        if (!sobol) return Vec2(to_unit(key.x), to_unit(key.y));
        if (pair != dimension::first_direction) return owen_sobol_2d(sample, key);
        const Words film_key = pcg4d({seed, pixel, dimension::film, 0});
        return owen_sobol_next_2d(sample, film_key.x, key);
    }
    HD float get_1d(std::uint32_t pair) const { return get_2d(pair).x; }

    // All numbers of a bounce at once. A CPU computes its four pairs side by side.
    HD_HOT BounceNumbers get_bounce(std::uint32_t bounce) const;
};

// Where in its pixel a camera ray goes through, in [0, 1)^2: a random point if jitter is on, else
// the middle.
HD Vec2 film_point(bool jitter, const Sampler& sampler) {
    path_is_at(sampler.pixel, sampler.sample, camera_ray_stop);
    return jitter ? sampler.get_2d(dimension::film) : Vec2(0.5f);
}

HD_HOT BounceNumbers Sampler::get_bounce(std::uint32_t bounce) const {
    path_is_at(pixel, sample, static_cast<int>(bounce));
    const std::uint32_t first = bounce_dimension(bounce, 0);
    Vec2 u[dimension::per_bounce];
    if (kind == SamplerKind::sobol) {
        for (std::uint32_t k = 0; k < dimension::per_bounce; ++k)
            u[k] = owen_sobol_2d(sample, pcg4d({seed, pixel, first + k, 0}));
        if (bounce == 0) u[dimension::direction] = get_2d(dimension::first_direction);
    } else {
        for (std::uint32_t k = 0; k < dimension::per_bounce; ++k) u[k] = get_2d(first + k);
    }
    const Vec2 lobe_roulette = u[dimension::lobe_roulette];
    return {u[dimension::light_point], u[dimension::light_choice].x, u[dimension::direction],
            lobe_roulette.x, lobe_roulette.y};
}

// Whitted's tracer sends a shadow ray to every light from every node of its ray tree. Each of them
// has a pair of dimensions of its own; a hash of node and light gives its number.
HD std::uint32_t shadow_ray_dimension(std::uint32_t node, int light) {
    return pcg4d({bounce_dimension(node, dimension::light_point), std::uint32_t(light), 0, 0}).x;
}

} // namespace raylab
