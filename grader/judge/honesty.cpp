// Facts about noise: medians and signs, so that no single firefly speaks for an image.
#include "grader/judge/honesty.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raylab {
namespace {

double median(std::vector<double> values) {
    if (values.empty()) return std::nan("");
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

// Sign correlation of the noise of two replicates. The noise is taken from differences of
// neighbouring pixels, in which a smooth error of the image cancels, and by its sign, so that no
// firefly decides. Turned into a linear correlation by sin(pi / 2 x), which is exact for normal
// noise.
double noise_correlation(const Image& a, const Image& b, const Image& reference) {
    const auto sign = [&](const Image& image, std::size_t i) {
        const double d = (double(luminance(image.mean[i])) - luminance(reference.mean[i])) -
                         (double(luminance(image.mean[i + 1])) - luminance(reference.mean[i + 1]));
        return (d > 0) - (d < 0);
    };
    long sum = 0, count = 0;
    for (std::size_t i = 0; i + 1 < a.pixels(); i += 2) {
        const int s = sign(a, i), t = sign(b, i);
        sum += s * t;
        count += s != 0 && t != 0;
    }
    return count == 0 ? 0 : std::sin(std::numbers::pi / 2 * double(sum) / double(count));
}

// Whether the reference has noise at all, or the scene is drawn without randomness.
bool is_noisy(const Image& reference) {
    if (reference.error.empty()) return true;
    for (std::size_t i = 0; i < reference.pixels(); ++i) {
        if (luminance(reference.error[i]) > 1e-6 * luminance(reference.mean[i])) return true;
    }
    return false;
}

TileSums variance_tiles(const Image& image) {
    return {image.width, image.height, [&](std::size_t i) { return image.variance(i); }};
}

// Per tile, the luminance of the pixels' variance, averaged.
std::vector<double> tile_variance(const Image& image) {
    const TileSums sums = variance_tiles(image);
    std::vector<double> values;
    for (const Region& region : regions_of(image.width, image.height, tile_size))
        values.push_back(glm::dot(luminance_weights, sums.over(region)) / region.pixels());
    return values;
}

// Median of a / b over tiles where both are above 0.
double median_ratio(const std::vector<double>& a, const std::vector<double>& b) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (a[i] > 0 && b[i] > 0) ratios.push_back(a[i] / b[i]);
    return median(std::move(ratios));
}

// Variance of tile means over (sum of pixel variances) / N^2, channel by channel added up.
double tile_ratio(const Replicates& replicates, const Image& mean) {
    const TileSums pixel_variance = variance_tiles(mean);
    std::vector<double> of_means, of_pixels;
    for (const Region& region : regions_of(mean.width, mean.height, tile_size)) {
        const glm::dmat3 covariance = moments_of(replicates, region).covariance;
        const DVec3 independent = pixel_variance.over(region);
        const double n = region.pixels();
        of_means.push_back(covariance[0][0] + covariance[1][1] + covariance[2][2]);
        of_pixels.push_back((independent.x + independent.y + independent.z) / (n * n));
    }
    return median_ratio(of_means, of_pixels);
}

} // namespace

Honesty check_honesty(const Replicates& first, const Image& reference, const Replicates* second) {
    Honesty result;
    const auto& images = first.images;
    const Image mean = mean_of(first);

    double correlation = 0;
    bool equal = true;
    for (std::size_t r = 0; r + 1 < images.size(); ++r) {
        equal = equal && images[r].mean == images[r + 1].mean;
        if (r % 2 == 0) correlation += noise_correlation(images[r], images[r + 1], reference);
    }
    const std::size_t pairs = images.size() / 2;
    result.replicate_correlation = correlation / double(pairs);
    result.seed_ignored = equal && is_noisy(reference);
    if (!result.seed_ignored && result.replicate_correlation > 0.3)
        result.hints.push_back(fmt::format(
            "Renders with different seeds share {:.0f} % of their noise: does every random number "
            "depend on the seed?",
            100 * result.replicate_correlation));

    // The mean's variance is that over count * spp samples, the reference's over its spp.
    const std::vector<double> noise = tile_variance(mean);
    if (!reference.error.empty() && reference.provenance.spp > 0) {
        const double ratio = median_ratio(noise, tile_variance(reference)) * first.count() *
                             first.spp / reference.provenance.spp;
        if (std::isfinite(ratio)) result.variance_ratio = ratio;
        if (ratio < 0.25)
            result.hints.push_back(fmt::format("A sample has {:.2g} of the reference's variance: "
                                               "are results cached, reused or denoised?",
                                               ratio));
        if (ratio > 4)
            result.hints.push_back(fmt::format(
                "A sample has {:.1f} times the reference's variance: correct, but noisy. "
                "Is a technique missing (light sampling, MIS, importance sampling)?",
                ratio));
    }

    const double tiles = tile_ratio(first, mean);
    if (std::isfinite(tiles)) result.tile_ratio = tiles;
    if (tiles > 4)
        result.hints.push_back(
            "Neighbouring pixels share their noise: are they blurred, denoised, or "
            "drawn with the same random numbers?");

    if (second) {
        const Image later = mean_of(*second);
        const double fall = median_ratio(noise, tile_variance(later));
        if (std::isfinite(fall)) result.variance_fall = fall;
        if (fall < 1.4)
            result.hints.push_back(fmt::format(
                "Twice the samples divide the variance by {:.2f} only, instead of 2: are samples "
                "repeated?",
                fall));
    }
    return result;
}

} // namespace raylab
