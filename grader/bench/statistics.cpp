#include "grader/bench/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace raylab::bench {

namespace {

constexpr double wanted_coverage = 0.95;
constexpr double infinity = std::numeric_limits<double>::infinity();

// The rank k (from 1) of the interval's ends and its coverage.
struct Ends {
    int k;
    double coverage;
};

Ends median_interval(int n) {
    double below = std::pow(0.5, n), term = below; // P(Binomial < 1), and its last term
    Ends ends = {1, 1 - 2 * below};
    for (int k = 2; 2 * k <= n; ++k) {
        term *= double(n - k + 2) / double(k - 1);
        below += term;
        if (1 - 2 * below < wanted_coverage) break;
        ends = {k, 1 - 2 * below};
    }
    return ends;
}

double median_of_sorted(const std::vector<double>& v) {
    const std::size_t n = v.size();
    return n % 2 == 1 ? v[n / 2] : (v[n / 2 - 1] + v[n / 2]) / 2;
}

// P(U = u), u = 0 .. n m, of the Mann-Whitney statistic when both samples are from one source: the
// coefficients of the Gaussian binomial, prod_(i=1..n) (1 - q^(m+i)) / (1 - q^i).
std::vector<double> mann_whitney(int n, int m) {
    std::vector<double> p(static_cast<std::size_t>(n * m + 1), 0);
    p[0] = 1;
    for (int i = 1; i <= n; ++i) {
        for (int u = n * m; u >= m + i; --u) p[u] -= p[u - m - i];
        for (int u = i; u <= n * m; ++u) p[u] += p[u - i];
    }
    double sum = 0;
    for (const double x : p) sum += x;
    for (double& x : p) x /= sum;
    return p;
}

} // namespace

double interval_coverage(int n) { return median_interval(n).coverage; }

Measured measured(std::vector<double> rounds) {
    Measured result;
    result.rounds = std::move(rounds);
    std::vector<double> sorted = result.rounds;
    std::erase_if(sorted, [](double v) { return std::isnan(v); });
    std::sort(sorted.begin(), sorted.end());
    const std::size_t n = result.rounds.size(), anywhere = n - sorted.size();
    result.median = 2 * anywhere < n ? median_of_sorted(sorted) : infinity;
    if (std::isinf(result.median)) {
        result.median = result.low = result.high = std::numeric_limits<double>::quiet_NaN();
        return result;
    }
    // The k-th from either end, of all n.
    const std::size_t k = median_interval(static_cast<int>(n)).k;
    result.low = k > anywhere ? sorted[k - anywhere - 1] : -infinity;
    result.high = k > anywhere ? sorted[sorted.size() - (k - anywhere)] : infinity;
    return result;
}

Line fit_line(const std::vector<double>& x, const std::vector<double>& y) {
    const double n = static_cast<double>(x.size());
    double mean_x = 0, mean_y = 0, xx = 0, xy = 0;
    for (std::size_t i = 0; i < x.size(); ++i) mean_x += x[i] / n, mean_y += y[i] / n;
    for (std::size_t i = 0; i < x.size(); ++i) {
        xx += (x[i] - mean_x) * (x[i] - mean_x);
        xy += (x[i] - mean_x) * (y[i] - mean_y);
    }
    if (x.size() != y.size() || xx == 0)
        throw std::invalid_argument("fit_line: at least two different x are needed");
    const double slope = xy / xx;
    return {mean_y - slope * mean_x, slope};
}

double fit_exponent(const std::vector<double>& x, const std::vector<double>& y) {
    std::vector<double> log_x, log_y;
    for (const double v : x) log_x.push_back(std::log(v));
    for (const double v : y) log_y.push_back(std::log(v));
    return fit_line(log_x, log_y).slope;
}

Ratio ratio_of(const std::vector<double>& after, const std::vector<double>& before) {
    std::vector<double> quotients;
    for (const double a : after)
        for (const double b : before) quotients.push_back(a / b);
    if (quotients.empty()) throw std::invalid_argument("ratio_of: both samples need values");
    std::sort(quotients.begin(), quotients.end());

    // [q_(k), q_(nm+1-k)] misses with probability 2 P(U < k).
    const std::vector<double> p =
        mann_whitney(static_cast<int>(after.size()), static_cast<int>(before.size()));
    std::size_t k = 1;
    double below = p[0];
    while (2 * (k + 1) <= quotients.size() && 1 - 2 * (below + p[k]) >= wanted_coverage)
        below += p[k++];
    return {median_of_sorted(quotients), quotients[k - 1], quotients[quotients.size() - k],
            1 - 2 * below};
}

} // namespace raylab::bench
