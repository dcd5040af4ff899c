// Every region and channel of two images, each error taken from the image's own variance.
#include "grader/judge/compare.h"

#include <fmt/format.h>

#include <cmath>
#include <cstring>

namespace raylab {
namespace {

constexpr double rounding = 1e-5; // relative differences below this are no differences
constexpr const char* channel_names[] = {"red", "green", "blue"};

Estimate channel(const ReferenceTiles& tiles, const Region& region, int c) {
    DVec3 axis(0);
    axis[c] = 1;
    return project(tiles.moments(region, glm::dmat3(1)), axis);
}

bool same_bits(const Image& a, const Image& b) {
    return std::memcmp(a.mean.data(), b.mean.data(), a.mean.size() * sizeof(Vec3)) == 0;
}

} // namespace

Comparison compare(const Image& a, const Image& b, const Image* reference, double alpha) {
    Comparison result;
    result.false_alarm_rate = alpha;
    for (const auto& [image, name] :
         {std::pair(&a, "first"), std::pair(&b, "second"), std::pair(reference, "reference")}) {
        if (!image) continue;
        const Soundness soundness = check_soundness(*image, b.width, b.height);
        if (soundness.verdict.passed) continue;
        result.verdict.sentence =
            fmt::format("In the {} image: {}", name, soundness.verdict.sentence);
        return result;
    }

    result.equal = same_bits(a, b);
    result.z_map = z_map(a, b);
    result.metrics = measure(a, reference ? *reference : b);
    if (reference) result.metrics_b = measure(b, *reference);
    if (result.equal) {
        result.decided = result.verdict.passed = true;
        result.verdict.sentence = "The images are equal bit for bit.";
        return result;
    }
    if (a.variance.empty() && b.variance.empty()) {
        result.verdict.sentence =
            fmt::format("The images differ by {:+.3g} % in mean; neither carries a variance, so "
                        "noise and error "
                        "cannot be told apart. Compare .exr files that raylab rendered.",
                        100 * result.metrics.rel_error);
        return result;
    }
    if (a.variance.empty() || b.variance.empty())
        result.verdict.hints.push_back(
            fmt::format("The {} image carries no variance and was taken as exact.",
                        a.variance.empty() ? "first" : "second"));

    const ReferenceTiles tiles_a(a), tiles_b(b);
    std::vector<Region> regions{{0, 0, a.width, a.height}};
    for (const int size : {tile_size, 2 * tile_size})
        if (size < std::max(a.width, a.height))
            for (const Region& region : regions_of(a.width, a.height, size))
                regions.push_back(region);
    for (const Region& region : regions)
        for (int c = 0; c < 3; ++c) {
            Estimate x = channel(tiles_a, region, c);
            const Estimate y = channel(tiles_b, region, c);
            const double d = x.mean - y.mean, tolerance = rounding * std::abs(y.mean);
            x.mean = std::abs(d) <= tolerance ? y.mean : x.mean - std::copysign(tolerance, d);
            const TestResult test = welch_t(x, y);
            if (result.tests++ > 0 && test.p >= result.worst.p) continue;
            result.worst = test;
            result.worst_region = region;
            result.worst_channel = c;
            result.worst_relative = y.mean != 0 ? d / y.mean : d == 0 ? 0 : INFINITY;
        }

    result.decided = true;
    result.verdict.passed = result.worst.p >= alpha / result.tests;
    const std::string where =
        result.worst_region == regions[0] ? "the whole image" : to_string(result.worst_region);
    result.verdict.sentence = fmt::format(
        "The images are {}: the largest deviation of {} tests is {:+.2f} % in {}, {} (t = {:.1f}); "
        "two correct renders are called different 1 time in {:.0f}.",
        result.verdict.passed ? "consistent" : "different", result.tests,
        100 * result.worst_relative, channel_names[result.worst_channel], where,
        result.worst.statistic, 1 / alpha);
    return result;
}

} // namespace raylab
