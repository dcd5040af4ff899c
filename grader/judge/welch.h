// Do two noisy estimates mean the same? Welch's t-test for one number and Hotelling's T^2 for two,
// both for unequal, estimated variances.
//
// B. L. Welch, "The generalization of Student's problem when several different population variances
// are involved", Biometrika 34 (1947). D. G. Nel and C. A. van der Merwe, "A solution to the
// multivariate Behrens-Fisher problem", Communications in Statistics 15 (1986).
#pragma once

#include <glm/glm.hpp>

namespace raylab {

// A number known with an error: `variance` is that of the mean itself (not of one observation) and
// was estimated with `dof` degrees of freedom.
struct Estimate {
    double mean = 0, variance = 0, dof = 1;
};

struct Estimate2 {
    glm::dvec2 mean{0};
    glm::dmat2 covariance{0};
    double dof = 1;
};

struct TestResult {
    double statistic = 0; // t with its sign, or T^2
    double dof = 0;
    double p = 1; // probability of so large a statistic if both mean the same
};

// t = (a - b) / sqrt(va + vb), degrees of freedom (va + vb)^2 / (va^2 / na + vb^2 / nb).
TestResult welch_t(const Estimate& a, const Estimate& b);

// T^2 = d^T (Va + Vb)^-1 d, referred to 2 n / (n - 1) F(2, n - 1) with Nel and van der Merwe's n.
TestResult hotelling_t2(const Estimate2& a, const Estimate2& b);

} // namespace raylab
