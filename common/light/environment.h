// Light from infinitely far away. It is constant, or comes from a map over latitude and longitude
// (Environment in scene/view.h describes the layout). PBR4e 12.5 (Infinite Area Lights).
//
// Each texel has one constant radiance, on the part of the sphere between two meridians and two
// circles of latitude. Sampling chooses a texel, and then a direction uniformly inside it. So the
// density is P(texel) / (solid angle of the texel): constant over the texel, and finite at the
// poles. A density in (u, v) would divide by sin(theta) = 0 there.
#pragma once

#include "common/light/light_sample.h"
#include "common/math/features.h"
#include "common/math/index.h"
#include "common/sampling/warp.h"
#include "common/scene/view.h"

namespace raylab {

struct Texel {
    int column, row;
};

// The texel for a direction. theta comes from atan2, because acos(y) is inaccurate near the poles.
// A tiny negative longitude wraps to just below 1, or rounds to 1; both are in the last column.
HD Texel environment_texel(const Environment& environment, Vec3 d) {
    const float phi = atan2f(d.z, d.x) * inv_two_pi + environment.turn;
    const float u = phi < 0 ? phi + 1 : phi;
    const float v = atan2f(sqrtf(d.x * d.x + d.z * d.z), d.y) * inv_pi;
    return {index_of(u * environment.width, environment.width),
            index_of(v * environment.height, environment.height)};
}

HD Vec3 environment_radiance(const Environment& environment, Texel texel) {
    return environment.radiance * environment.map[texel.row * environment.width + texel.column];
}

// Radiance that arrives from direction d, unit.
template <Features F> HD Vec3 environment_radiance(const SceneView& scene, Vec3 d) {
    const Environment& environment = scene.environment;
    if constexpr ((F & feature::environment_map) != 0)
        if (environment.map.size > 0)
            return environment_radiance(environment, environment_texel(environment, d));
    return environment.radiance;
}

// 1 - cos(theta) = 2 sin^2(theta / 2) at the top edge of a row, theta = pi row / height.
HD float row_edge(const Environment& environment, int row) {
    return 2 * sqr(cos_sin_turn(row / (4.0f * environment.height)).y);
}

// 2 pi / width times (cos(top) - cos(bottom)). The difference is computed as the product
// 2 sin(theta) sin(half), so no digits cancel: theta is the middle of the row, half is half its
// height.
HD float texel_solid_angle(const Environment& environment, int row) {
    const float theta = (row + 0.5f) / (2 * environment.height), half = 0.25f / environment.height;
    return two_pi / environment.width * 2 * cos_sin_turn(theta).y * cos_sin_turn(half).y;
}

HD float environment_map_pdf(const Environment& environment, Texel texel) {
    const float* rows = environment.row_cdf.data + texel.row;
    const float* columns =
        environment.column_cdf.data + texel.row * (environment.width + 1) + texel.column;
    return (rows[1] - rows[0]) * (columns[1] - columns[0]) /
           texel_solid_angle(environment, texel.row);
}

// The last i < n with cdf[i] <= u. So u lies in [cdf[i], cdf[i + 1]), which is not empty.
HD int find_interval(const float* cdf, int n, float u) {
    int low = 0, high = n; // cdf[low] <= u, and u < cdf[high] = 1
    while (high - low > 1) {
        const int middle = (low + high) / 2;
        if (cdf[middle] <= u)
            low = middle;
        else
            high = middle;
    }
    return low;
}

HD LightSample sample_environment_map(const Environment& environment, Vec2 u) {
    // Choose the texel. The position of u inside the chosen interval is uniform again, and serves
    // to choose the point in the texel.
    const float* rows = environment.row_cdf.data;
    const int row = find_interval(rows, environment.height, u.y);
    const float* columns = environment.column_cdf.data + row * (environment.width + 1);
    const int column = find_interval(columns, environment.width, u.x);
    const float s = (u.x - columns[column]) / (columns[column + 1] - columns[column]);
    const float t = (u.y - rows[row]) / (rows[row + 1] - rows[row]);

    // Uniform in solid angle is uniform in cos(theta). Heights are measured from the nearer pole,
    // as 1 - |cos(theta)|, which stays exact where |cos(theta)| is near 1.
    const bool upper = 2 * row < environment.height;
    const int edge = upper ? row : environment.height - row;
    const int next = upper ? edge + 1 : edge - 1;
    const float h = (1 - t) * row_edge(environment, edge) + t * row_edge(environment, next);
    const Vec2 meridian = cos_sin_turn((column + s) / environment.width - environment.turn);
    const float sin_theta = safe_sqrt(h * (2 - h));
    const Vec3 wi(sin_theta * meridian.x, upper ? 1 - h : h - 1, sin_theta * meridian.y);

    LightSample sample;
    sample.n = -wi;
    sample.wi = wi;
    sample.distance = infinity;
    sample.radiance = environment_radiance(environment, {column, row});
    sample.pdf = environment_map_pdf(environment, {column, row});
    sample.valid = sample.pdf > 0;
    return sample;
}

template <Features F> HD LightSample sample_environment(const Environment& environment, Vec2 u) {
    if constexpr ((F & feature::environment_map) != 0)
        if (environment.map.size > 0) return sample_environment_map(environment, u);
    const Vec3 wi = sample_uniform_sphere(u);
    return {Vec3(0), 0, -wi, wi, infinity, environment.radiance, uniform_sphere_pdf, false, true};
}

template <Features F> HD float environment_pdf(const Environment& environment, Vec3 wi) {
    if constexpr ((F & feature::environment_map) != 0)
        if (environment.map.size > 0)
            return environment_map_pdf(environment, environment_texel(environment, wi));
    return uniform_sphere_pdf;
}

} // namespace raylab
