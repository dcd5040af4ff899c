// Pixel by pixel for images; sample by sample and surface by surface for the first difference.
#include "grader/judge/same_paths.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace raylab {
namespace {

// Largest |a - b| / max(|a|, |b|) of the three channels. Relative to each channel's own value, so
// that brightness does not matter.
double relative_difference(Vec3 a, Vec3 b) {
    double largest = 0;
    for (int c = 0; c < 3; ++c) {
        if (a[c] == b[c]) continue;
        const double scale = std::max(std::abs(double(a[c])), std::abs(double(b[c])));
        largest = std::max(largest, std::abs(double(a[c]) - double(b[c])) / scale);
    }
    return largest;
}

} // namespace

SamePathsResult judge_same_paths(const Image& image, const Image& reference,
                                 const SamePathsOptions& options) {
    const Provenance &a = image.provenance, &b = reference.provenance;
    if (a.seed != b.seed || a.spp != b.spp)
        throw std::invalid_argument(
            fmt::format("judge_same_paths: the image has seed {} and {} spp, the reference seed {} "
                        "and {} spp; both must be equal",
                        a.seed, a.spp, b.seed, b.spp));
    SamePathsResult result;
    result.soundness = check_soundness(image, reference.width, reference.height);
    if (!result.soundness.verdict.passed) {
        result.verdict = result.soundness.verdict;
        return result;
    }

    const double paths = double(image.pixels()) * std::max(1, b.spp);
    result.allowed_pixels = static_cast<std::size_t>(std::ceil(options.parted_paths * paths));
    for (std::size_t i = 0; i < image.pixels(); ++i) {
        const double difference = relative_difference(image.mean[i], reference.mean[i]);
        result.largest_relative_difference =
            std::max(result.largest_relative_difference, difference);
        if (difference <= options.relative_tolerance) continue;
        if (result.differing_pixels++ > 0) continue;
        result.first_x = static_cast<int>(i % static_cast<std::size_t>(image.width));
        result.first_y = static_cast<int>(i / static_cast<std::size_t>(image.width));
        result.first_value = image.mean[i];
        result.first_reference = reference.mean[i];
    }

    result.verdict.passed = result.differing_pixels <= result.allowed_pixels;
    if (result.differing_pixels == 0)
        result.verdict.sentence =
            fmt::format("The same paths as the reference: all {} pixels agree to {:.1e}.",
                        image.pixels(), result.largest_relative_difference);
    else if (result.verdict.passed)
        result.verdict.sentence = fmt::format(
            "The same paths as the reference, except in {} of {} pixels (rounding at an edge; {} "
            "are allowed).",
            result.differing_pixels, image.pixels(), result.allowed_pixels);
    else
        result.verdict.sentence = fmt::format(
            "{} of {} pixels differ from the reference with the same random numbers; the first is "
            "({}, {}): ({:.6g}, {:.6g}, {:.6g}) instead of ({:.6g}, {:.6g}, {:.6g}).",
            result.differing_pixels, image.pixels(), result.first_x, result.first_y,
            result.first_value.x, result.first_value.y, result.first_value.z,
            result.first_reference.x, result.first_reference.y, result.first_reference.z);
    if (!result.verdict.passed && result.differing_pixels > image.pixels() / 2)
        result.verdict.hints.push_back("Most pixels differ: perhaps only the random numbers are "
                                       "others. Statistics over several seeds will tell.");
    return result;
}

std::optional<FirstDifference> find_first_difference(int x, int y, int spp, int max_depth,
                                                     const SampleValue& value,
                                                     const SampleValue& reference,
                                                     const SamePathsOptions& options) {
    for (int sample = 0; sample < spp; ++sample) {
        for (int depth = 1; depth <= max_depth; ++depth) {
            const Vec3 a = value(x, y, sample, depth), b = reference(x, y, sample, depth);
            // !(<=): a NaN differs from everything.
            if (!(relative_difference(a, b) <= options.relative_tolerance) || !is_finite(a))
                return FirstDifference{x, y, sample, depth, a, b};
        }
    }
    return std::nullopt;
}

} // namespace raylab
