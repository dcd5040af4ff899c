// The two tests, guarded against noise that is zero, tiny, or on one line of colour space.
#include "grader/judge/welch.h"

#include "grader/judge/distributions.h"

#include <cmath>
#include <limits>

namespace raylab {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// tr(V^2) + (tr V)^2, the size of a covariance in Nel and van der Merwe's formula.
double size(const glm::dmat2& v) {
    const double trace = v[0][0] + v[1][1];
    const glm::dmat2 square = v * v;
    return square[0][0] + square[1][1] + trace * trace;
}

} // namespace

TestResult welch_t(const Estimate& a, const Estimate& b) {
    const double difference = a.mean - b.mean, variance = a.variance + b.variance;
    if (difference == 0) return {0, infinity, 1};
    // If there is no noise at all, any difference is significant.
    if (variance <= 0) return {std::copysign(infinity, difference), infinity, 0};
    TestResult result;
    // As shares of the total: the squares of tiny variances would underflow.
    const double share = a.variance / variance;
    result.dof = 1 / (share * share / a.dof + (1 - share) * (1 - share) / b.dof);
    result.statistic = difference / std::sqrt(variance);
    result.p = student_t_two_sided(result.statistic, result.dof);
    return result;
}

TestResult hotelling_t2(const Estimate2& a, const Estimate2& b) {
    const glm::dvec2 d = a.mean - b.mean;
    const glm::dmat2 v = a.covariance + b.covariance;
    if (d == glm::dvec2(0)) return {0, infinity, 1};
    const double scale = (v[0][0] + v[1][1]) / 2;
    if (scale <= 0) return {infinity, infinity, 0};

    TestResult result;
    result.dof =
        size(v / scale) / (size(a.covariance / scale) / a.dof + size(b.covariance / scale) / b.dof);
    if (result.dof <= 1) return {0, result.dof, 1}; // too few observations to say anything
    // The noise of a grey scene lies on one line of colour space. In the other direction the
    // variance is known to rounding only, so it gets a millionth of the larger standard deviation.
    glm::dmat2 regular = v;
    regular[0][0] += 1e-12 * scale;
    regular[1][1] += 1e-12 * scale;
    result.statistic = glm::dot(d, glm::inverse(regular) * d);
    const double n = result.dof;
    result.p = f2_tail(result.statistic * (n - 1) / (2 * n), n - 1);
    return result;
}

} // namespace raylab
