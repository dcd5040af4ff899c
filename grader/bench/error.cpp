#include "grader/bench/error.h"

#include "grader/judge/distributions.h"
#include "grader/judge/welch.h"

#include <cmath>
#include <stdexcept>

namespace raylab::bench {

namespace {

double mean_level(const Image& image) {
    double sum = 0;
    std::size_t n = 0;
    for (const Vec3& v : image.mean)
        if (is_finite(v)) sum += double(v.x) + double(v.y) + double(v.z), n += 3;
    return n > 0 ? sum / double(n) : 0;
}

// Averages scale (a - b)^2 - noise(pixel, channel).
template <class Noise>
MeasuredError average(const Image& a, const Image& b, const Image& level, double scale,
                      Noise noise) {
    if (a.width != b.width || a.height != b.height || a.width != level.width ||
        a.height != level.height)
        throw std::invalid_argument("image error: the images must have the same size");
    const double mean = mean_level(level);
    MeasuredError sum;
    std::size_t n = 0;
    for (std::size_t i = 0; i < a.pixels(); ++i) {
        if (!is_finite(a.mean[i]) || !is_finite(b.mean[i]) || !is_finite(level.mean[i])) continue;
        for (int c = 0; c < 3; ++c, ++n) {
            const double d = double(a.mean[i][c]) - double(b.mean[i][c]);
            const double l = double(level.mean[i][c]), weight = l * l + 1e-4 * mean * mean;
            const double error = scale * d * d - noise(i, c);
            sum.mse += error;
            if (weight > 0) sum.rel_mse += error / weight;
        }
    }
    if (n == 0) return {NAN, NAN};
    return {sum.mse / double(n), sum.rel_mse / double(n)};
}

double mean_luminance(const Image& image) {
    double sum = 0;
    for (const Vec3& v : image.mean) sum += double(luminance(v));
    return sum / double(image.pixels());
}

// The variance of an image's mean luminance; its channels' noise is taken as fully correlated.
double variance_of_mean(const Image& image) {
    double sum = 0;
    for (const Vec3& v : image.error) {
        const double error = 0.2126 * v.x + 0.7152 * v.y + 0.0722 * v.z;
        sum += error * error;
    }
    return sum / (double(image.pixels()) * double(image.pixels()));
}

} // namespace

MeasuredError error_against(const Image& image, const Image& reference) {
    return average(image, reference, reference, 1, [&](std::size_t i, int c) {
        return reference.error.empty() ? 0.0 : reference.variance(i)[c];
    });
}

MeasuredError error_of_pair(const Image& a, const Image& b, const Image& level) {
    return average(a, b, level, 0.5, [](std::size_t, int) { return 0.0; });
}

Bias bias_of(const std::vector<const Image*>& renders, const Image& truth) {
    const double n = static_cast<double>(renders.size());
    if (renders.size() < 2) throw std::invalid_argument("bias_of: at least two renders are needed");
    double mean = 0, squares = 0;
    for (const Image* image : renders) mean += mean_luminance(*image) / n;
    for (const Image* image : renders) {
        const double d = mean_luminance(*image) - mean;
        squares += d * d;
    }
    const Estimate ours = {mean, squares / (n * (n - 1)), n - 1};
    const Estimate theirs = {mean_luminance(truth), variance_of_mean(truth),
                             double(truth.pixels())};
    if (theirs.mean <= 0) return {NAN, NAN, NAN};
    const double error = std::sqrt(ours.variance + theirs.variance) / theirs.mean;
    const auto half_width = [&](double p) {
        return error > 0 ? student_t_quantile(p, welch_t(ours, theirs).dof) * error : 0;
    };
    return {ours.mean / theirs.mean - 1, half_width(0.05), half_width(0.001)};
}

} // namespace raylab::bench
