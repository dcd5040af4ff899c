// Sums over pixels for the error measures, and over tiles for the z-map.
#include "grader/judge/metrics.h"

#include "grader/judge/moments.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace raylab {

namespace {

bool knows_all_errors(const Image& image) {
    return !image.error.empty() && std::all_of(image.error.begin(), image.error.end(),
                                               [](const Vec3& v) { return is_finite(v); });
}

double known_variance(const Image& image, std::size_t i, int c) {
    return !image.error.empty() && std::isfinite(image.error[i][c]) ? image.variance(i)[c] : 0;
}

} // namespace

Metrics measure(const Image& image, const Image& reference) {
    if (image.width != reference.width || image.height != reference.height)
        throw std::invalid_argument("measure: the images must have the same size");
    double squares = 0, relative = 0, variance = 0, sum_a = 0, sum_r = 0, mean = 0;
    std::size_t n = 0;
    for (std::size_t i = 0; i < image.pixels(); ++i)
        if (is_finite(image.mean[i]) && is_finite(reference.mean[i]))
            for (int c = 0; c < 3; ++c, ++n) mean += double(reference.mean[i][c]);
    Metrics result;
    if (n == 0) return result;
    mean /= double(n);

    for (std::size_t i = 0; i < image.pixels(); ++i) {
        const Vec3 a = image.mean[i], r = reference.mean[i];
        if (!is_finite(a) || !is_finite(r)) continue;
        sum_a += double(luminance(a));
        sum_r += double(luminance(r));
        for (int c = 0; c < 3; ++c) {
            const double d = double(a[c]) - double(r[c]);
            const double var_a = known_variance(image, i, c);
            const double var_r = known_variance(reference, i, c);
            const double weight = double(r[c]) * double(r[c]) + 1e-4 * mean * mean;
            squares += d * d;
            variance += var_a + var_r;
            if (weight > 0) relative += (d * d - var_r) / weight;
        }
    }
    result.mse = squares / double(n);
    result.rel_mse = relative / double(n);
    result.rel_error = sum_r > 0 ? sum_a / sum_r - 1 : 0;
    result.rel_bias = knows_all_errors(image)
                          ? std::sqrt(std::max(0.0, (squares - variance) / double(n)))
                          : std::numeric_limits<double>::quiet_NaN();
    if (mean > 0) result.rel_bias /= mean;
    return result;
}

ZMap z_map(const Image& image, const Image& reference) {
    const glm::dmat3 fully_correlated(1, 1, 1, 1, 1, 1, 1, 1, 1);
    const ReferenceTiles a(image), r(reference);
    ZMap map;
    map.tile = tile_size;
    map.columns = (image.width + tile_size - 1) / tile_size;
    map.rows = (image.height + tile_size - 1) / tile_size;
    for (const Region& region : regions_of(image.width, image.height, tile_size)) {
        const Estimate x = project(a.moments(region, fully_correlated), luminance_weights);
        const Estimate y = project(r.moments(region, fully_correlated), luminance_weights);
        const bool known = (image.error.empty() || a.unknown(region) == 0) &&
                           (reference.error.empty() || r.unknown(region) == 0) &&
                           !(image.error.empty() && reference.error.empty());
        map.z.push_back(x.mean == y.mean ? 0
                        : known          ? (x.mean - y.mean) / std::sqrt(x.variance + y.variance)
                                         : std::numeric_limits<double>::quiet_NaN());
    }
    return map;
}

} // namespace raylab
