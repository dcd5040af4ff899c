#include "app/expectation.h"

#include <fmt/format.h>

#include <cmath>

namespace raylab::app {

namespace {

DVec3 region_mean(const Image& image, std::array<int, 4> region) {
    auto [x0, y0, x1, y1] = region;
    if (x1 <= x0 || y1 <= y0) x0 = y0 = 0, x1 = image.width, y1 = image.height;
    DVec3 sum(0);
    for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x) sum += DVec3(image.at(x, y));
    return sum / (static_cast<double>(x1 - x0) * (y1 - y0));
}

} // namespace

// A measured value may differ by the stated tolerance plus four standard errors. So a right
// renderer fails one check in 16,000.
ExpectationResult check_expectation(const Expectation& expectation,
                                    const std::vector<Image>& replicates) {
    const double n = static_cast<double>(replicates.size());
    DVec3 sum(0), sum_squares(0);
    for (const Image& image : replicates) {
        const DVec3 mean = region_mean(image, expectation.region);
        sum += mean;
        sum_squares += mean * mean;
    }
    ExpectationResult result{true, 0, 0, 0, ""};
    double worst = -1;
    for (int c = 0; c < 3; ++c) {
        const double mean = sum[c] / n;
        const double variance = std::max(0.0, sum_squares[c] / n - mean * mean) / (n - 1);
        const double expected = expectation.value[c], error = std::sqrt(variance);
        const double allowed = expectation.tolerance * std::fabs(expected) + 4 * error;
        const double off = std::fabs(mean - expected);
        const bool met = off <= allowed;
        if (!met) result.met = false;
        const double badness = allowed > 0 ? off / allowed : off;
        if (badness > worst) {
            worst = badness;
            result.value = mean, result.expected = expected, result.standard_error = error;
        }
    }
    result.sentence =
        fmt::format("{}: {:.8g}, found {:.8g} +- {:.1g}: {}", expectation.formula, result.expected,
                    result.value, result.standard_error, result.met ? "met" : "NOT MET");
    return result;
}

} // namespace raylab::app
