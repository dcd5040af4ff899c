// Statistics of a value that was measured a few times on a noisy machine.
//
// Medians with distribution-free intervals: nothing is assumed about how other programs disturb the
// clock. Order-statistic intervals: H. A. David, H. N. Nagaraja, Order Statistics (2003), 7.1. The
// ratio of two samples: J. L. Hodges, E. L. Lehmann, "Estimates of Location Based on Rank Tests",
// Annals of Mathematical Statistics 34 (1963).
#pragma once

#include <vector>

namespace raylab::bench {

// One value a round. A value of -infinity or infinity is below or above all that can be measured.
// NaN may be anywhere, so it counts as -infinity for `low` and as infinity for `high`. If `low` or
// `high` is infinite, the interval is open at that end. The median is that of the values that are
// not NaN. If it is infinite, or half of the values are NaN, nothing is known, and all three are
// NaN.
struct Measured {
    std::vector<double> rounds; // in the order of the rounds
    double median = 0, low = 0, high = 0;

    bool is_known() const { return median == median; }
};

Measured measured(std::vector<double> rounds);

// The probability that [low, high] holds the true median: of n values the k-th smallest and the
// k-th largest, k as large as leaves 95 %, or the extremes,
//     1 - 2 P(Binomial(n, 1/2) < k):  n = 5: 93.75 %,  6: 96.9 %,  9: 96.1 %.
double interval_coverage(int n);

// y = intercept + slope x by least squares. At least two different x.
struct Line {
    double intercept, slope;
};
Line fit_line(const std::vector<double>& x, const std::vector<double>& y);

// The slope of log y over log x: -1 where y = C / x.
double fit_exponent(const std::vector<double>& x, const std::vector<double>& y);

// By what factor `after` lies above `before`: the median of all n m quotients, with the interval
// that the Mann-Whitney test leaves. Values > 0.
struct Ratio {
    double median, low, high;
    double coverage; // at least 95 % from 4 against 4 values on; less for fewer

    // Is 1 outside the interval?
    bool is_change() const { return low > 1 || high < 1; }
};
Ratio ratio_of(const std::vector<double>& after, const std::vector<double>& before);

} // namespace raylab::bench
