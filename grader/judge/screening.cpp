// All regions of one stage, with the floor under their variance that the reference gives.
#include "grader/judge/screening.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace raylab {
namespace {

double variance_along(const DVec3& axis, const glm::dmat3& covariance) {
    return glm::dot(axis, covariance * axis);
}

// Both sides of one region.
struct Pair {
    Moments image, reference;
    double kurtosis = 0;
};

// Replicates and reference, and the variance of the replicates that the reference predicts.
class Sides {
  public:
    Sides(const Replicates& replicates, const ReferenceTiles& reference, int reference_spp,
          const ScreeningOptions& options)
        : replicates_(replicates), reference_(reference),
          // A mean over n samples has variance v / n.
          predicted_(double(reference_spp) / (double(replicates.count()) * replicates.spp)) {
        const Image& image = replicates.images[0];
        const std::vector<Region> regions = regions_of(image.width, image.height, tile_size);
        for (const Region& region : regions)
            covariance_ += moments_of(replicates, region).covariance;
        if (!options.variance_floor) return;
        DVec3 measured(0), predicted(0);
        for (const Region& region : regions) {
            const Pair pair = of(region);
            for (int a = 0; a < 3; ++a) {
                measured[a] += variance_along(colour_axes[a], pair.image.covariance);
                predicted[a] +=
                    predicted_ * variance_along(colour_axes[a], pair.reference.covariance);
            }
        }
        for (int a = 0; a < 3; ++a)
            if (predicted[a] > 0) floor_[a] = std::min(1.0, measured[a] / predicted[a]);
    }

    Pair of(const Region& region) const {
        Pair pair;
        pair.image = moments_of(replicates_, region, &pair.kurtosis);
        pair.reference = reference_.moments(region, covariance_);
        const glm::dmat3 predicted = pair.reference.covariance * predicted_;
        double missing = 0;
        for (int a = 0; a < 3; ++a) {
            const double v = variance_along(colour_axes[a], predicted);
            if (v <= 0) continue;
            const double share = variance_along(colour_axes[a], pair.image.covariance) / v;
            missing = std::max(missing, floor_[a] - share);
        }
        pair.image.covariance += missing * predicted;
        return pair;
    }

  private:
    const Replicates& replicates_;
    const ReferenceTiles& reference_;
    double predicted_;         // variance of the replicates' mean over that of the reference
    glm::dmat3 covariance_{0}; // sum over regions: how the channels' noise is correlated
    DVec3 floor_{0};           // share of the predicted variance to be had, by colour axis
};

// Differences below `tolerance` become 0, larger ones shrink by it.
void forgive_rounding(Estimate& a, const Estimate& b, double tolerance) {
    const double d = a.mean - b.mean;
    a.mean = std::abs(d) <= tolerance ? b.mean : a.mean - std::copysign(tolerance, d);
}

void forgive_rounding(Estimate2& a, const Estimate2& b, double tolerance) {
    const glm::dvec2 d = a.mean - b.mean;
    const double length = glm::length(d);
    a.mean = length <= tolerance ? b.mean : a.mean - d * (tolerance / length);
}

double rounding_of(const Pair& pair, const ScreeningOptions& options) {
    return options.rounding * glm::dot(luminance_weights, glm::abs(pair.reference.mean));
}

TestResult test_along(const Pair& pair, const DVec3& direction, const ScreeningOptions& options) {
    Estimate a = project(pair.image, direction);
    const Estimate b = project(pair.reference, direction);
    forgive_rounding(a, b, rounding_of(pair, options) * glm::length(direction));
    return welch_t(a, b);
}

RegionTest describe(const Pair& pair, const Region& region, bool of_chroma) {
    RegionTest test;
    test.region = region;
    test.chroma = of_chroma;
    test.direction = luminance_weights;
    test.image = pair.image.mean;
    test.reference = pair.reference.mean;
    const double a = project(pair.image, luminance_weights).variance;
    const double b = project(pair.reference, luminance_weights).variance;
    test.standard_error = std::sqrt(a + b);
    test.reference_share = a + b > 0 ? b / (a + b) : 0;
    return test;
}

// The colour direction along which the chroma difference stands out most: V^-1 d, in R, G, B.
DVec3 chroma_direction(const Estimate2& a, const Estimate2& b) {
    glm::dmat2 v = a.covariance + b.covariance;
    const double scale = (v[0][0] + v[1][1]) / 2;
    const glm::dvec2 d = a.mean - b.mean;
    if (scale <= 0) return {d.x, -d.x - d.y, d.y};
    v /= scale;
    v[0][0] += 1e-12;
    v[1][1] += 1e-12;
    const glm::dvec2 w = glm::inverse(v) * d;
    return {w.x, -w.x - w.y, w.y};
}

void test_region(const Pair& pair, const Region& region, const ScreeningOptions& options,
                 std::vector<RegionTest>& tests) {
    RegionTest light = describe(pair, region, false);
    light.test = test_along(pair, luminance_weights, options);
    tests.push_back(light);

    RegionTest colour = describe(pair, region, true);
    Estimate2 a = chroma(pair.image);
    const Estimate2 b = chroma(pair.reference);
    forgive_rounding(a, b, rounding_of(pair, options));
    colour.test = hotelling_t2(a, b);
    colour.direction = chroma_direction(a, b);
    tests.push_back(colour);
}

} // namespace

Screening screen(const Replicates& replicates, const ReferenceTiles& reference, int reference_spp,
                 const ScreeningOptions& options) {
    if (replicates.count() < 4) throw std::invalid_argument("screen: 4 replicates are needed");
    const int width = replicates.images[0].width, height = replicates.images[0].height;
    const Region whole{0, 0, width, height};
    const Sides sides(replicates, reference, reference_spp, options);
    Screening result;
    std::vector<Region> level = regions_of(width, height, tile_size), merged;
    for (int size = tile_size; size < std::max(width, height); size *= 2) {
        if (size <= 2 * tile_size) result.planned += 2 * static_cast<int>(level.size());
        merged.clear();
        for (const Region& region : level) {
            const Pair pair = sides.of(region);
            if (pair.kurtosis <= options.kurtosis_limit) {
                test_region(pair, region, options, result.tests);
                continue;
            }
            ++result.merged;
            const Region parent = parent_of(region, size, width, height);
            if (std::find(merged.begin(), merged.end(), parent) == merged.end())
                merged.push_back(parent);
        }
        // All squares of 2 x 2 tiles are tested in any case; larger squares only where a smaller
        // one was merged.
        level = size == tile_size ? regions_of(width, height, 2 * tile_size) : merged;
    }
    result.planned += 2;
    const Pair pair = sides.of(whole);
    test_region(pair, whole, options, result.tests);
    result.whole = result.tests[result.tests.size() - 2];
    result.worst = *std::min_element(
        result.tests.begin(), result.tests.end(),
        [](const RegionTest& a, const RegionTest& b) { return a.test.p < b.test.p; });
    return result;
}

TestResult retest(const Replicates& replicates, const ReferenceTiles& reference, int reference_spp,
                  const Region& region, const DVec3& direction, const ScreeningOptions& options) {
    return test_along(Sides(replicates, reference, reference_spp, options).of(region), direction,
                      options);
}

} // namespace raylab
