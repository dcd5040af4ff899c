// What the statistical tests share: seeded random numbers, means with their standard error, and
// Pearson's chi-square test.
//
// Seeds are fixed, so a test's verdict never changes from run to run; the false-alarm rates that
// tests state are those of their choice of seed. RAYLAB_LONG=1 in the environment asks for full
// counts.
#pragma once

#include "common/math/numbers.h"
#include "common/math/vec.h"

#include <cmath>
#include <cstdlib>
#include <random>
#include <vector>

namespace raylab::test {

inline int count(int quick, int full) { return std::getenv("RAYLAB_LONG") ? full : quick; }

class Random {
  public:
    explicit Random(unsigned seed) : engine(seed) {}
    float u() { return (engine() >> 8) * 0x1p-24f; } // in [0, 1)
    Vec2 square() { // one call a statement: the order of arguments' evaluation is the compiler's
        const float x = u();
        return Vec2(x, u());
    }
    float between(float low, float high) { return low + (high - low) * u(); }
    Vec3 direction() {
        const double z = 1 - 2.0 * u(), phi = 2 * M_PI * u(), r = std::sqrt(1 - z * z);
        return Vec3(r * std::cos(phi), r * std::sin(phi), z);
    }

  private:
    std::mt19937 engine;
};

struct Mean {
    double sum = 0, sum2 = 0, n = 0;

    void add(double x) { sum += x, sum2 += x * x, n += 1; }
    double mean() const { return sum / n; }
    double standard_error() const {
        return std::sqrt(std::fmax(sum2 / n - mean() * mean(), 0.0) / n);
    }
};

// P(X > x) of the chi-square distribution: the upper incomplete gamma function Q(dof / 2, x / 2),
// by its series or its continued fraction (Press et al., Numerical Recipes 6.2).
inline double chi_square_tail(double x, double dof) {
    const double a = dof / 2, h = x / 2;
    if (h <= 0) return 1;
    const double scale = std::exp(-h + a * std::log(h) - std::lgamma(a));
    if (h < a + 1) {
        double term = 1 / a, sum = term;
        for (double k = a + 1; term > sum * 1e-15; ++k) sum += term *= h / k;
        return 1 - scale * sum;
    }
    double b = h + 1 - a, c = 1e300, d = 1 / b, fraction = d;
    for (int i = 1; i < 10000; ++i) {
        const double an = -i * (i - a);
        b += 2;
        d = 1 / (an * d + b);
        c = b + an / c;
        fraction *= d * c;
        if (std::fabs(d * c - 1) < 1e-15) break;
    }
    return scale * fraction;
}

// The p-value of observed counts against expected ones. Cells that expect fewer than 5 are pooled
// (the approximation by chi-square needs that); a count where nothing may be gives 0.
inline double chi_square_p(const std::vector<double>& observed,
                           const std::vector<double>& expected) {
    double chi2 = 0, pooled_observed = 0, pooled_expected = 0;
    int cells = 0;
    const auto add = [&](double o, double e) {
        chi2 += (o - e) * (o - e) / e;
        ++cells;
    };
    for (std::size_t i = 0; i < observed.size(); ++i) {
        if (expected[i] <= 0 && observed[i] > 0) return 0;
        if (expected[i] >= 5)
            add(observed[i], expected[i]);
        else
            pooled_observed += observed[i], pooled_expected += expected[i];
    }
    if (pooled_expected > 0.5) add(pooled_observed, pooled_expected);
    return chi_square_tail(chi2, cells - 1);
}

// The same against equal counts in every cell.
inline double chi_square_uniform_p(const std::vector<double>& observed) {
    double total = 0;
    for (double o : observed) total += o;
    return chi_square_p(observed, std::vector<double>(observed.size(), total / observed.size()));
}

// The correlation coefficient of pairs.
struct Correlation {
    double n = 0, x = 0, y = 0, xx = 0, yy = 0, xy = 0;

    void add(double a, double b) { n += 1, x += a, y += b, xx += a * a, yy += b * b, xy += a * b; }
    double r() const {
        return (xy / n - x * y / (n * n)) /
               std::sqrt((xx / n - x * x / (n * n)) * (yy / n - y * y / (n * n)));
    }
};

} // namespace raylab::test
