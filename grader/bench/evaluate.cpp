#include "grader/bench/evaluate.h"

#include "grader/judge/independent.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace raylab::bench {

namespace {

constexpr double tolerated_bias = 0.005;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

// What images are judged against.
struct Truth {
    const Image* reference; // or null: errors come from pairs, agreement from `image`
    Image image;            // the reference, or the mean of the first contestant
    std::string from;       // whose mean it is; empty: the reference file
};

Replicates replicates_at_most_samples(const Turns& turns, const Plan& plan) {
    Replicates result{plan.spp.back(), {}, {}};
    for (const auto& round : turns.drawn) result.add(round.back().image);
    return result;
}

// The radiance that errors are relative to where there is no reference: the mean of everything that
// was drawn right, blurred over 5 x 5 pixels. A contestant's own mean would follow its own noise
// and flatter it, and in dark pixels any noise in a divisor weighs heavily.
Image common_level(const std::vector<Turns>& all, const std::vector<Row>& rows, const Image& like) {
    constexpr int reach = 2;
    const int width = like.width, height = like.height;
    std::vector<DVec3> sum(like.pixels(), DVec3(0));
    double weights = 0;
    for (std::size_t k = 0; k < all.size(); ++k) {
        if (!rows[k].agrees) continue;
        for (const auto& round : all[k].drawn)
            for (const Drawn& drawn : round) {
                const double weight = drawn.spp;
                weights += weight;
                for (std::size_t i = 0; i < sum.size(); ++i)
                    sum[i] += weight * DVec3(drawn.image.mean[i]);
            }
    }
    Image level{width, height, std::vector<Vec3>(like.pixels()), {}, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const int x0 = std::max(x - reach, 0), x1 = std::min(x + reach, width - 1);
            const int y0 = std::max(y - reach, 0), y1 = std::min(y + reach, height - 1);
            DVec3 local(0);
            for (int v = y0; v <= y1; ++v)
                for (int u = x0; u <= x1; ++u) local += sum[std::size_t(v) * width + u];
            level.mean[std::size_t(y) * width + x] =
                Vec3(local / (weights * (x1 - x0 + 1) * (y1 - y0 + 1)));
        }
    return level;
}

// Every error of a contestant, [which spp][round].
std::vector<std::vector<MeasuredError>> errors_of(const Turns& turns, const Truth& truth,
                                                  const Image& level) {
    const std::size_t rounds = turns.drawn.size(), counts = turns.drawn[0].size();
    std::vector<std::vector<MeasuredError>> errors(counts);
    for (std::size_t i = 0; i < counts; ++i)
        for (std::size_t r = 0; r < rounds; ++r) {
            const Image& image = turns.drawn[r][i].image;
            const Image& next = turns.drawn[(r + 1) % rounds][i].image;
            errors[i].push_back(truth.reference ? error_against(image, *truth.reference)
                                                : error_of_pair(image, next, level));
        }
    return errors;
}

// a / b of values above 0. Where one of them is beyond what can be measured (see Measured), so is
// the quotient; where both are, it may lie anywhere.
double quotient(double a, double b) {
    if (std::isfinite(b)) return a / b;
    return std::isfinite(a) ? -b : nan;
}

// In a disturbed round the time did not grow with the samples. Leaving out such rounds would leave
// the slow ones, and the median would be too large. So the slope of such a round counts as below
// all that can be measured; for a median only the order matters.
void evaluate_time(Row& row, const Turns& turns, const Plan& plan) {
    const std::vector<double> x(plan.spp.begin(), plan.spp.end());
    std::vector<double> slopes, intercepts;
    for (const auto& round : turns.drawn) {
        std::vector<double> seconds;
        for (const Drawn& drawn : round) seconds.push_back(drawn.seconds);
        const Line line = fit_line(x, seconds);
        slopes.push_back(line.slope > 0 ? 1000 * line.slope : -infinity);
        intercepts.push_back(line.intercept);
    }
    row.ms_per_spp = measured(slopes);
    row.start_up = measured(intercepts);
    const auto disturbed = std::count(slopes.begin(), slopes.end(), -infinity);
    if (disturbed == 0) return;
    const std::string fact = fmt::format(
        "Its time did not grow with the samples in {} of {} rounds", disturbed, slopes.size());
    row.remarks.push_back(
        row.ms_per_spp.is_known()
            ? fact + ": they were disturbed, count as faster than the others, and may leave an "
                     "interval open. Raise --rounds or --spp."
            : fact + ": it is too short to be measured. Raise --spp or --size.");
}

void evaluate_error(Row& row, const std::vector<std::vector<MeasuredError>>& errors,
                    const Plan& plan, double target) {
    const double most = plan.spp.back();
    const std::vector<double> x(plan.spp.begin(), plan.spp.end());
    std::vector<double> mse, rel_mse, efficiency, seconds, exponents;
    for (std::size_t r = 0; r < errors[0].size(); ++r) {
        const MeasuredError error = errors.back()[r];
        const double slope = row.ms_per_spp.rounds[r] / 1000;
        mse.push_back(error.mse);
        rel_mse.push_back(error.rel_mse);
        efficiency.push_back(error.mse > 0 ? quotient(1 / (error.mse * most), slope) : nan);
        seconds.push_back(error.rel_mse > 0 ? error.rel_mse * most / target * slope : nan);
        std::vector<double> y;
        for (const auto& at_spp : errors) y.push_back(at_spp[r].rel_mse);
        exponents.push_back(fit_exponent(x, y)); // NaN where an error is not above 0
    }
    const double mean_mse =
        std::accumulate(mse.begin(), mse.end(), 0.0) / static_cast<double>(mse.size());
    row.mse = measured(mse);
    row.rel_mse = measured(rel_mse);
    row.efficiency = measured(efficiency);
    row.seconds_to_target = measured(seconds);
    row.exponent = measured(exponents);
    for (std::size_t i = 0; i < errors.size(); ++i) {
        std::vector<double> relative, absolute;
        for (const MeasuredError& error : errors[i]) {
            relative.push_back(error.rel_mse);
            absolute.push_back(error.mse);
        }
        row.points.push_back({plan.spp[i], plan.spp[i] * row.ms_per_spp.median / 1000,
                              measured(relative).median, measured(absolute).median});
    }
    if (!row.efficiency.is_known() && row.ms_per_spp.is_known())
        row.remarks.push_back(
            "No noise is left that could be measured, so efficiency says nothing.");
    if (row.exponent.is_known() && (row.exponent.low > -0.9 || row.exponent.high < -1.1))
        row.remarks.push_back(fmt::format(
            "Its relMSE falls as n^{:.2f}, not as 1 / n: efficiency and the time to the target "
            "hold near {} spp.",
            row.exponent.median, plan.spp.back()));
    if (mean_mse > 1.25 * row.mse.median)
        row.remarks.push_back(fmt::format(
            "Rare bright samples: the mean MSE of the rounds is {:.2g} times their median.",
            mean_mse / row.mse.median));
}

void judge_images(Row& row, const Turns& turns, const Truth& truth, const Plan& plan) {
    const Replicates replicates = replicates_at_most_samples(turns, plan);
    if (truth.from == row.name) {
        row.bias = {nan, nan, nan};
        const Soundness soundness =
            check_soundness(truth.image, truth.image.width, truth.image.height);
        row.agrees = soundness.verdict.passed;
        row.verdict = row.agrees ? "The others are judged against it." : soundness.verdict.sentence;
        return;
    }
    std::vector<const Image*> images;
    for (const Image& image : replicates.images) images.push_back(&image);
    const Image& any = *images.front();
    if (any.width != truth.image.width || any.height != truth.image.height) {
        row.verdict = fmt::format("images differ: its size is {} x {}, not {} x {}", any.width,
                                  any.height, truth.image.width, truth.image.height);
        return;
    }
    IndependentOptions options;
    options.spp = plan.spp.back();
    const IndependentResult judged = judge_replicates(replicates, truth.image, options);
    row.bias = bias_of(images, truth.image);
    const bool mean_agrees =
        std::abs(row.bias.relative) <= tolerated_bias + row.bias.half_width_999;
    row.agrees = judged.verdict.passed && mean_agrees;
    if (!judged.verdict.passed)
        row.verdict = "images differ: " + judged.verdict.sentence;
    else if (!mean_agrees)
        row.verdict = fmt::format("images differ: the mean is off by {:+.2f} +- {:.2f} %",
                                  100 * row.bias.relative, 100 * row.bias.half_width_95);
    else
        row.verdict = fmt::format("agrees; an even error of {:.2g} % would have been found",
                                  100 * judged.detectable_relative_error);
}

void copy_ledger(Row& row, const Turns& turns) {
    const Drawn& last = turns.drawn.back().back();
    if (last.bytes > 0) row.bytes_per_path = last.bytes / double(last.image.pixels());
    if (!last.ledger) return;
    const Ledger& ledger = *last.ledger;
    std::vector<double> speeds;
    for (const auto& round : turns.drawn)
        speeds.push_back(double(round.back().ledger->rays()) / round.back().ledger->seconds);
    row.rays_per_second = measured(speeds).median;
    if (ledger.rejected > 0)
        row.remarks.push_back(
            fmt::format("{} samples were not finite and were left out: a bug.", ledger.rejected));
    for (const BounceCounts& bounce : ledger.bounces) {
        if (bounce.rays == 0) break;
        BouncePoint point{double(bounce.rays) / double(ledger.bounces[0].rays), {}};
        if (bounce.lanes > 0) point.lanes_share = lanes_alive(bounce);
        row.bounces.push_back(point);
    }
}

// Round by round.
Measured quotients(const std::vector<double>& a, const std::vector<double>& b) {
    std::vector<double> result;
    for (std::size_t r = 0; r < a.size(); ++r) result.push_back(quotient(a[r], b[r]));
    return measured(result);
}

// Only between images that agree: a fast wrong image is no result.
void divide_by_baseline(std::vector<Row>& rows, const std::string& baseline) {
    const auto found = std::find_if(rows.begin(), rows.end(),
                                    [&](const Row& row) { return row.name == baseline; });
    if (found == rows.end()) return;
    found->is_baseline = true;
    if (!found->agrees) return;
    for (Row& row : rows) {
        if (!row.agrees) continue;
        const Measured speed = quotients(found->ms_per_spp.rounds, row.ms_per_spp.rounds);
        const Measured efficiency = quotients(row.efficiency.rounds, found->efficiency.rounds);
        if (speed.is_known()) row.speed_ratio = speed;
        if (efficiency.is_known()) row.efficiency_ratio = efficiency;
    }
}

} // namespace

std::vector<Row> evaluate(const std::vector<Turns>& all, const Image* reference,
                          const EvaluateOptions& options) {
    Truth truth{reference, {}, ""};
    if (reference) truth.image = *reference;
    std::vector<Row> rows;
    for (const Turns& turns : all) {
        Row& row = rows.emplace_back();
        row.name = turns.name;
        row.title = turns.title;
        row.failure = turns.failure;
        if (!turns.failure.empty()) continue;
        if (truth.image.mean.empty()) {
            truth.image = mean_of(replicates_at_most_samples(turns, options.plan));
            truth.from = turns.name;
        }
        evaluate_time(row, turns, options.plan);
        judge_images(row, turns, truth, options.plan);
        copy_ledger(row, turns);
    }
    const Image level = reference ? *reference : common_level(all, rows, truth.image);
    for (std::size_t k = 0; k < all.size(); ++k) {
        if (!all[k].failure.empty()) continue;
        const Image& drawn = all[k].drawn[0].back().image;
        if (drawn.width == level.width && drawn.height == level.height)
            evaluate_error(rows[k], errors_of(all[k], truth, level), options.plan,
                           options.target_rel_mse);
    }
    divide_by_baseline(rows, options.baseline);
    return rows;
}

} // namespace raylab::bench
