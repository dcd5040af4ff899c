// Moments over replicates, and of a reference whose file holds an error a pixel and channel.
#include "grader/judge/moments.h"

#include "common/image/mean.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace raylab {

const DVec3 luminance_weights(0.2126, 0.7152, 0.0722);
const DVec3 colour_axes[3] = {luminance_weights, {1, -1, 0}, {0, -1, 1}};

namespace {

constexpr double noise_floor = 1e-6; // relative noise below this is not noise

// Excess kurtosis m4 / m2^2 - 3 of the values along one axis; 0 where they do not vary.
double excess_kurtosis(const std::vector<DVec3>& values, const DVec3& mean, const DVec3& axis) {
    double m2 = 0, m4 = 0;
    for (const DVec3& v : values) {
        const double d = glm::dot(v - mean, axis);
        m2 += d * d;
        m4 += d * d * d * d;
    }
    const double n = double(values.size()), level = noise_floor * glm::length(mean);
    return m2 <= n * level * level ? 0 : m4 * n / (m2 * m2) - 3;
}

double correlation(const glm::dmat3& covariance, int a, int b) {
    const double v = covariance[a][a] * covariance[b][b];
    return a == b ? 1 : v > 0 ? covariance[a][b] / std::sqrt(v) : 0;
}

} // namespace

void Replicates::add(Image image) {
    if (!images.empty() && (image.width != images[0].width || image.height != images[0].height))
        throw std::invalid_argument("Replicates: all images must have the same size");
    tiles.emplace_back(image.mean, image.width, image.height);
    images.push_back(std::move(image));
}

Image mean_of(const Replicates& replicates) {
    ImageMean sum;
    for (const Image& image : replicates.images) sum.add(image);
    Image mean = sum.mean();
    mean.provenance.spp = replicates.spp * replicates.count();
    return mean;
}

Moments moments_of(const Replicates& replicates, const Region& region, double* kurtosis) {
    const double n = replicates.count(), pixels = region.pixels();
    std::vector<DVec3> values;
    Moments result;
    for (const TileSums& tiles : replicates.tiles) {
        values.push_back(tiles.over(region) / pixels);
        result.mean += values.back() / n;
    }
    for (const DVec3& v : values)
        result.covariance += glm::outerProduct(v - result.mean, v - result.mean);
    result.covariance /= n * (n - 1);
    result.dof = n - 1;
    if (kurtosis) {
        *kurtosis = 0;
        for (const DVec3& axis : colour_axes)
            *kurtosis = std::max(*kurtosis, excess_kurtosis(values, result.mean, axis));
    }
    return result;
}

namespace {

bool knows_error(const Image& image, std::size_t i) {
    return !image.error.empty() && is_finite(image.error[i]);
}

DVec3 known_variance(const Image& image, std::size_t i) {
    return knows_error(image, i) ? image.variance(i) : DVec3(0);
}

} // namespace

ReferenceTiles::ReferenceTiles(const Image& r)
    : mean_(r.mean, r.width, r.height),
      variance_(r.width, r.height, [&](std::size_t i) { return known_variance(r, i); }),
      squared_variance_(r.width, r.height,
                        [&](std::size_t i) {
                            const DVec3 v = known_variance(r, i);
                            return v * v;
                        }),
      unknown_(r.width, r.height, [&](std::size_t i) { return DVec3(!knows_error(r, i)); }) {}

Moments ReferenceTiles::moments(const Region& region, const glm::dmat3& like) const {
    const double pixels = region.pixels();
    const DVec3 variance = variance_.over(region), squares = squared_variance_.over(region);
    const DVec3 deviation = glm::sqrt(variance) / pixels;
    Moments result;
    result.mean = mean_.over(region) / pixels;
    for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b)
            result.covariance[a][b] = deviation[a] * deviation[b] * correlation(like, a, b);
    double dof = pixels;
    for (int c = 0; c < 3; ++c)
        if (squares[c] > 0) dof = std::min(dof, variance[c] * variance[c] / squares[c]);
    result.dof = std::max(1.0, dof);
    return result;
}

Estimate project(const Moments& m, const DVec3& direction) {
    return {glm::dot(m.mean, direction), glm::dot(direction, m.covariance * direction), m.dof};
}

Estimate2 chroma(const Moments& m) {
    const DVec3 &u = colour_axes[1], &v = colour_axes[2];
    const double uv = glm::dot(u, m.covariance * v);
    return {{glm::dot(u, m.mean), glm::dot(v, m.mean)},
            glm::dmat2(glm::dot(u, m.covariance * u), uv, uv, glm::dot(v, m.covariance * v)),
            m.dof};
}

} // namespace raylab
