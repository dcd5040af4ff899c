// A texel's share of the light: its luminance times the solid angle it covers, which on a map by
// latitude and longitude is proportional to sin(theta) at its middle (PBR4e 12.5.2).
#include "common/load/environment_map.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

namespace raylab {
namespace {

// Random numbers are multiples of 2^-24 (sampling/hash.h). The tables' values are such multiples
// too, so a texel is chosen with exactly the probability in the tables.
constexpr double grains = 0x1p24;

// The least density of a texel that is not black, as a part of the density of even sampling. Beside
// a sun of 10^12 the sky's share of the light is almost 0, but where the sun does not reach, the
// sky is the only light.
constexpr double least = 1 / 16.0;

double light_of(Vec3 rgb) { // luminance, without underflow
    return 0.2126 * double(rgb.x) + 0.7152 * double(rgb.y) + 0.0722 * double(rgb.z);
}

// Appends P(place < i). A place with light is chosen in proportion to its light, but at least
// `least` times as often as in proportion to its size; if all places are black, in proportion to
// size. No place with light gets less than one grain.
void append_cdf(const std::vector<double>& light, const std::vector<double>& size,
                std::vector<float>& cdf) {
    double all_light = 0, all_size = 0;
    for (const double l : light) all_light += l;
    for (const double s : size) all_size += s;
    std::vector<double> share(light.size());
    double total = 0, lit = 0;
    for (std::size_t i = 0; i < light.size(); ++i) {
        const double even = size[i] / all_size;
        if (all_light == 0)
            share[i] = even;
        else if (light[i] > 0)
            share[i] = std::max(light[i] / all_light, least * even);
        total += share[i];
        lit += share[i] > 0;
    }
    double sum = 0, before = 0;
    for (const double s : share) {
        cdf.push_back(float((std::round((grains - lit) * (sum / total)) + before) / grains));
        sum += s;
        before += s > 0;
    }
    cdf.push_back(1);
}

} // namespace

float rotate_map(Picture& map, double degrees) {
    const double columns = std::fmod(degrees, 360) / 360 * map.width;
    const double whole = std::round(columns);
    const auto shift = std::ptrdiff_t(whole < 0 ? whole + map.width : whole);
    for (int y = 0; y < map.height; ++y) {
        const auto row = map.texels.begin() + std::ptrdiff_t(y) * map.width;
        std::rotate(row, row + shift % map.width, row + map.width);
    }
    // How far the rounding of the angle, and of what is computed from it, may move a column.
    const double rounding =
        4 * std::numeric_limits<double>::epsilon() * std::fabs(degrees) / 360 * map.width;
    const double left = columns - whole;
    return std::fabs(left) <= rounding ? 0 : float(left / map.width);
}

EnvironmentCdf environment_cdf(const Picture& map) {
    const std::size_t width = map.width, height = map.height;
    EnvironmentCdf cdf;
    cdf.row.reserve(height + 1);
    cdf.column.reserve(height * (width + 1));
    std::vector<double> row_light(height), row_size(height), light(width);
    const std::vector<double> size(width, 1);
    for (std::size_t y = 0; y < height; ++y) {
        row_size[y] = std::sin(std::numbers::pi * (y + 0.5) / height);
        for (std::size_t x = 0; x < width; ++x) {
            light[x] = light_of(map.texels[y * width + x]);
            row_light[y] += light[x] * row_size[y];
        }
        append_cdf(light, size, cdf.column);
    }
    append_cdf(row_light, row_size, cdf.row);
    return cdf;
}

} // namespace raylab
