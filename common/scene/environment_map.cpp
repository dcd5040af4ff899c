// A texel's share of the light: its luminance times the solid angle it covers, which on a map by
// latitude and longitude is proportional to sin(theta) at its middle (PBR4e 12.5.2).
#include "common/scene/environment_map.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace raylab {
namespace {

// Appends the running sums of the weights over their total; equal shares if all are 0.
void append_cdf(const std::vector<double>& weights, std::vector<float>& cdf) {
    double total = 0, sum = 0;
    for (const double w : weights) total += w;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        cdf.push_back(float(total > 0 ? sum / total : double(i) / double(weights.size())));
        sum += weights[i];
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
    // As far as the angle is rounded, and what is computed from it.
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
    std::vector<double> row_weight(height), weight(width);
    double total = 0;
    for (std::size_t y = 0; y < height; ++y) {
        const double sin_theta = std::sin(3.14159265358979323846 * (y + 0.5) / height);
        for (std::size_t x = 0; x < width; ++x) {
            weight[x] = double(luminance(map.texels[y * width + x])) * sin_theta;
            row_weight[y] += weight[x];
        }
        total += row_weight[y];
        append_cdf(weight, cdf.column);
    }
    if (total == 0) // any density that covers the sphere will do
        for (std::size_t y = 0; y < height; ++y)
            row_weight[y] = std::sin(3.14159265358979323846 * (y + 0.5) / height);
    append_cdf(row_weight, cdf.row);
    return cdf;
}

} // namespace raylab
