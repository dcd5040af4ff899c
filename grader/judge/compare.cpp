// Compares every region and channel of two pictures. A pixel whose error is not known counts as
// exact. If the images agree even then, they agree; if they do not, the question is left open.
#include "grader/judge/compare.h"

#include "grader/judge/noisy_image.h"

#include <fmt/format.h>

#include <cmath>
#include <cstring>

namespace raylab {
namespace {

constexpr double rounding = 1e-5; // relative differences below this are no differences
constexpr const char* channel_names[] = {"red", "green", "blue"};

bool same_bits(const Image& a, const Image& b) {
    return std::memcmp(a.mean.data(), b.mean.data(), a.mean.size() * sizeof(Vec3)) == 0;
}

// The whole image first, then squares of 2 x 2 tiles, then tiles.
std::vector<Region> all_regions(int width, int height) {
    std::vector<Region> regions{{0, 0, width, height}};
    for (const int size : {tile_size, 2 * tile_size})
        if (size < std::max(width, height))
            for (const Region& region : regions_of(width, height, size)) regions.push_back(region);
    return regions;
}

// A region's test in one channel.
struct Deviation {
    TestResult test;
    double relative = 0; // (a - b) / b
};

Deviation deviation(const NoisyImage& a, const NoisyImage& b, const Region& region, int c) {
    Estimate x = a.channel(region, c);
    const Estimate y = b.channel(region, c);
    const double d = x.mean - y.mean, tolerance = rounding * std::abs(y.mean);
    x.mean = std::abs(d) <= tolerance ? y.mean : x.mean - std::copysign(tolerance, d);
    return {welch_t(x, y), y.mean != 0 ? d / y.mean : d == 0 ? 0 : INFINITY};
}

// A clause that says what is not known of a side's noise, or "".
std::string ignorance(const NoisyImage& side, const char* name, const Region& whole) {
    const double unknown = side.unknown(whole);
    if (unknown == 0) return "";
    if (side.mean().error.empty()) return fmt::format("the {} image carries no variance", name);
    return fmt::format("{:.0f} pixels of the {} image have one sample, which tells no variance",
                       unknown, name);
}

std::string what_would_decide(const NoisyImage& a, const NoisyImage& b, const Region& whole) {
    const std::string first = ignorance(a, "first", whole), second = ignorance(b, "second", whole);
    return fmt::format(
        "{}{}{}, so noise and error cannot be told apart. Give replicates with seeds of their own: "
        "`raylab compare A1 A2 --with B1 B2`; or .exr files that raylab rendered with two samples "
        "a "
        "pixel or more; or say --exact if an image without variance has no noise.",
        first, first.empty() || second.empty() ? "" : " and ", second);
}

void note_shared_noise(Verdict& verdict, const char* name, double shared) {
    if (shared > 1.5)
        verdict.hints.push_back(fmt::format(
            "Neighbouring pixels of the {} side share their noise: a tile's mean varies "
            "{:.1f} times as much as that of independent pixels, and was judged so.",
            name, shared));
}

// false, with a sentence, if an image cannot be judged at all.
bool all_sound(const Replicates& a, const Replicates& b, const Image* reference, Verdict& verdict) {
    const auto sound = [&](const Image& image, const std::string& name) {
        const int width = a.images[0].width, height = a.images[0].height;
        const Soundness soundness = check_soundness(image, width, height);
        if (!soundness.verdict.passed)
            verdict.sentence = fmt::format("In the {} image: {}", name, soundness.verdict.sentence);
        return soundness.verdict.passed;
    };
    const auto all = [&](const Replicates& side, const std::string& name) {
        for (int r = 0; r < side.count(); ++r)
            if (!sound(side.images[r],
                       side.count() == 1 ? name : fmt::format("{} side's {}.", name, r + 1)))
                return false;
        return true;
    };
    return all(a, "first") && all(b, "second") && (!reference || sound(*reference, "reference"));
}

// Every region and channel. The worst stays in `result`: of those whose noise is known, if one of
// them differs, else of all.
void test_all(const NoisyImage& a, const NoisyImage& b, Comparison& result) {
    const std::vector<Region> regions = all_regions(a.mean().width, a.mean().height);
    const double threshold = result.false_alarm_rate / (3.0 * double(regions.size()));
    bool differs = false, open = false;
    for (const Region& region : regions) {
        const bool known = a.unknown(region) + b.unknown(region) == 0;
        for (int c = 0; c < 3; ++c) {
            const Deviation found = deviation(a, b, region, c);
            const bool suspect = found.test.p < threshold;
            const bool first_known = known && suspect && !differs;
            if (suspect) (known ? differs : open) = true;
            if (result.tests++ > 0 && !first_known &&
                (found.test.p >= result.worst.p || (differs && !known)))
                continue;
            result.worst = found.test;
            result.worst_relative = found.relative;
            result.worst_region = region;
            result.worst_channel = c;
        }
    }
    result.decided = differs || !open;
    result.verdict.passed = !differs && !open;
}

} // namespace

Comparison compare(const Replicates& replicates_a, const Replicates& replicates_b,
                   const Image* reference, const CompareOptions& options) {
    Comparison result;
    result.false_alarm_rate = options.alpha;
    result.replicates_a = replicates_a.count();
    result.replicates_b = replicates_b.count();
    if (!all_sound(replicates_a, replicates_b, reference, result.verdict)) {
        result.decided = true;
        return result;
    }
    const NoisyImage a(replicates_a, options.exact), b(replicates_b, options.exact);
    result.mean_a = a.mean();
    result.mean_b = b.mean();
    result.shared_noise_a = a.shared_noise();
    result.shared_noise_b = b.shared_noise();
    result.equal = same_bits(a.mean(), b.mean());
    result.verdict.measured = {measure(a.mean(), b.mean()), z_map(a.mean(), b.mean())};
    if (reference) {
        result.metrics_a = measure(a.mean(), *reference);
        result.metrics_b = measure(b.mean(), *reference);
    }
    if (result.equal) {
        result.decided = result.verdict.passed = true;
        result.verdict.sentence = "The images are equal bit for bit.";
        return result;
    }
    test_all(a, b, result);
    note_shared_noise(result.verdict, "first", result.shared_noise_a);
    note_shared_noise(result.verdict, "second", result.shared_noise_b);
    const Region whole = {0, 0, a.mean().width, a.mean().height};
    if (!result.decided) {
        result.verdict.sentence =
            fmt::format("Not decided: the images differ by {:+.3g} % in mean, and {}",
                        100 * result.metrics().rel_error, what_would_decide(a, b, whole));
        return result;
    }
    for (const std::string& unknown : {ignorance(a, "first", whole), ignorance(b, "second", whole)})
        if (!unknown.empty() && result.verdict.passed)
            result.verdict.hints.push_back("Taken as exact, and yet they agree: " + unknown + ".");
    const std::string where =
        result.worst_region == whole ? "the whole image" : to_string(result.worst_region);
    result.verdict.sentence = fmt::format(
        "The images are {}: the largest deviation of {} tests is {:+.2f} % in {}, {} (t = {:.1f}); "
        "two correct renders are called different 1 time in {:.0f}.",
        result.verdict.passed ? "consistent" : "different", result.tests,
        100 * result.worst_relative, channel_names[result.worst_channel], where,
        result.worst.statistic, 1 / options.alpha);
    return result;
}

Comparison compare(const Image& a, const Image& b, const Image* reference,
                   const CompareOptions& options) {
    Replicates first, second;
    first.add(a);
    second.add(b);
    return compare(first, second, reference, options);
}

} // namespace raylab
