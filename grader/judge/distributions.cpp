// Student's t by Boost.Math (incomplete beta function); F(2, n) has a closed form.
#include "grader/judge/distributions.h"

#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

#include <cmath>

namespace raylab {

// Beyond this Boost, too, takes the normal distribution.
constexpr double many = 1e20;

double student_t_two_sided(double t, double dof) {
    if (std::isinf(t)) return 0;
    const double x = std::abs(t);
    return dof > many ? std::erfc(x / std::sqrt(2.0))
                      : 2 * cdf(complement(boost::math::students_t(dof), x));
}

double student_t_quantile(double p, double dof) {
    return dof > many ? quantile(complement(boost::math::normal(), p / 2))
                      : quantile(complement(boost::math::students_t(dof), p / 2));
}

// log1p keeps the digits where 2 f / dof is small.
double f2_tail(double f, double dof) { return std::exp(-dof / 2 * std::log1p(2 * f / dof)); }

} // namespace raylab
