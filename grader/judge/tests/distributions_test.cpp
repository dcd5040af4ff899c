// The tails against closed forms and against integration of the density.
#include "grader/judge/distributions.h"

#include "grader/judge/welch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace raylab {
namespace {

constexpr double ts[] = {0.001, 0.3, 1, 2.5, 7, 20, 300};

TEST(StudentT, MeetsItsClosedForms) {
    for (const double t : ts) {
        const double one = 2 / std::numbers::pi * std::atan(1 / t);
        EXPECT_NEAR(student_t_two_sided(t, 1) / one, 1, 1e-12) << t;
        // 1 - t / sqrt(2 + t^2), without its cancellation.
        const double root = std::sqrt(2 + t * t), two = 2 / (root * (root + t));
        EXPECT_NEAR(student_t_two_sided(-t, 2) / two, 1, 1e-12) << t;
        if (t > 30) continue;
        const double normal = std::erfc(t / std::sqrt(2.0));
        EXPECT_NEAR(student_t_two_sided(t, std::numeric_limits<double>::infinity()) / normal, 1,
                    1e-12);
    }
}

// Simpson's rule on the substitution x = t / u, which turns [t, infinity) into (0, 1].
long double tail_by_integration(long double t, long double dof) {
    const long double c = std::exp(std::lgamma((dof + 1) / 2) - std::lgamma(dof / 2)) /
                          std::sqrt(dof * std::numbers::pi_v<long double>);
    const auto f = [&](long double u) {
        if (u == 0) return 0.0L;
        const long double x = t / u;
        return c * std::pow(1 + x * x / dof, -(dof + 1) / 2) * t / (u * u);
    };
    constexpr int n = 4000;
    long double sum = f(0) + f(1);
    for (int i = 1; i < n; ++i) sum += f(static_cast<long double>(i) / n) * (i % 2 ? 4 : 2);
    return 2 * sum / (3 * n);
}

TEST(StudentT, MeetsIntegrationForDegreesOfFreedomThatAreNotWhole) {
    for (const double dof : {3.0, 5.7, 15.0, 29.3})
        for (const double t : {0.8, 2.0, 6.0, 12.0})
            EXPECT_NEAR(student_t_two_sided(t, dof) / double(tail_by_integration(t, dof)), 1, 1e-11)
                << t << " " << dof;
}

TEST(StudentT, TheQuantileIsTheInverse) {
    for (const double p : {0.5, 0.01, 5e-4, 1e-9})
        for (const double dof : {1.0, 15.0, 1e30})
            EXPECT_NEAR(student_t_two_sided(student_t_quantile(p, dof), dof) / p, 1, 1e-9);
}

// F(1, n) = t^2; F(2, 2): P(F > f) = 1 / (1 + f).
TEST(FisherF, MeetsItsClosedForm) {
    for (const double f : ts) EXPECT_NEAR(f2_tail(f, 2) * (1 + f), 1, 1e-12);
    EXPECT_NEAR(f2_tail(3, 1e12), std::exp(-3.0), 1e-11);
}

// Welch 1947 as worked in textbooks: variances of the mean 3 and 1 with 9 and 14 degrees of
// freedom.
TEST(Welch, DegreesOfFreedomAndSign) {
    const TestResult r = welch_t({10, 3, 9}, {14, 1, 14});
    EXPECT_DOUBLE_EQ(r.statistic, -2);
    EXPECT_DOUBLE_EQ(r.dof, 16 / (9.0 / 9 + 1.0 / 14));
    EXPECT_EQ(welch_t({1, 0, 15}, {1, 0, 1}).p, 1);
    EXPECT_EQ(welch_t({1, 0, 15}, {2, 0, 1}).p, 0);
    EXPECT_FALSE(std::isnan(welch_t({1e-30, 1e-70, 15}, {0, 1e-72, 1}).p));
}

// With an exact reference T^2 is the classical one: (n - 1) / (2 n) T^2 ~ F(2, n - 1), n = R - 1.
TEST(Hotelling, DegreesOfFreedomOfTheClassicalCase) {
    const Estimate2 a{{1, 2}, glm::dmat2(2, 0.5, 0.5, 1), 15};
    const TestResult r = hotelling_t2(a, {});
    EXPECT_NEAR(r.dof, 15, 1e-9);
    // d^T V^-1 d by hand: V^-1 = [[1, -0.5], [-0.5, 2]] / 1.75.
    EXPECT_NEAR(r.statistic, (1 - 2 + 8) / 1.75, 1e-9);
    EXPECT_NEAR(r.p, f2_tail(r.statistic * 14 / 30, 14), 1e-12);
}

} // namespace
} // namespace raylab
