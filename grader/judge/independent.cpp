// The two stages of tier 2, and the sentence that says what they found.
#include "grader/judge/independent.h"

#include "grader/judge/distributions.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace raylab {
namespace {

bool same_sign(double a, double b) { return (a > 0) == (b > 0); }

// "once in 4 million".
std::string once_in(double rate) {
    const double n = 1 / rate;
    return n >= 1e6 ? fmt::format("once in {:.3g} million", n / 1e6)
                    : fmt::format("once in {:.0f}", n);
}

std::string difference_sentence(const RegionTest& worst, const Region& whole) {
    const std::string where =
        worst.region == whole ? "over the whole image" : "in " + to_string(worst.region);
    if (worst.chroma) {
        const DVec3 change = 100.0 * (worst.image - worst.reference);
        const DVec3 base = worst.reference;
        const auto percent = [&](int c) { return base[c] != 0 ? change[c] / base[c] : 0.0; };
        return fmt::format("The colour is wrong {}: R {:+.2f} %, G {:+.2f} %, B {:+.2f} %", where,
                           percent(0), percent(1), percent(2));
    }
    const double a = glm::dot(luminance_weights, worst.image);
    const double b = glm::dot(luminance_weights, worst.reference);
    if (b == 0) return fmt::format("There is light {} where there should be none", where);
    return fmt::format("The image is too {} by {:.2f} ± {:.2f} % {}", a > b ? "bright" : "dark",
                       100 * std::abs(a - b) / b, 100 * worst.standard_error / b, where);
}

// The relative error e with t = e mean / s that passes the threshold 99 times in 100.
double detectable(const Screening& screening, double alpha) {
    const RegionTest& whole = screening.whole;
    const double mean = glm::dot(luminance_weights, whole.reference);
    const double dof = std::isfinite(whole.test.dof) ? whole.test.dof : 1e30;
    if (mean == 0) return 0;
    const double threshold = student_t_quantile(alpha / screening.planned, dof);
    return (threshold + student_t_quantile(0.02, dof)) * whole.standard_error / mean;
}

// The verdict after the first stage; true if no difference was found.
bool first_stage(IndependentResult& result, const Replicates& replicates, const Image& reference,
                 const ReferenceTiles& tiles, const IndependentOptions& options) {
    result.screening = screen(replicates, tiles, reference.provenance.spp, options.screening);
    result.detectable_relative_error = detectable(result.screening, options.alpha);
    result.mean = mean_of(replicates);
    result.verdict.measured = {measure(result.mean, reference), z_map(result.mean, reference)};
    result.false_alarm_rate = options.alpha;
    if (reference.error.empty())
        result.verdict.hints.push_back("The reference carries no variance and was taken as exact.");
    else if (result.screening.whole.reference_share > 0.2)
        result.verdict.hints.push_back(fmt::format(
            "{:.0f} % of the variance is the reference's own: render it with more samples, or the "
            "false-alarm rate of the two stages is higher than stated.",
            100 * result.screening.whole.reference_share));
    return result.screening.worst.test.p >= options.alpha / result.screening.planned;
}

void conclude(IndependentResult& result, bool passed, const Image& reference) {
    const Screening& s = result.screening;
    Verdict& verdict = result.verdict;
    verdict.hints.insert(verdict.hints.end(), result.honesty.hints.begin(),
                         result.honesty.hints.end());
    if (result.honesty.seed_ignored) {
        verdict.passed = false;
        verdict.sentence =
            "Renders with different seeds are equal bit for bit: the seed is ignored.";
        return;
    }
    verdict.passed = passed;
    if (!passed) {
        const std::string twice =
            result.second ? fmt::format(", again {:.1f} with fresh seeds", result.second->statistic)
                          : "";
        verdict.sentence =
            fmt::format("{} ({} = {:.1f}{}; a correct renderer does so at most {}).",
                        difference_sentence(s.worst, {0, 0, reference.width, reference.height}),
                        s.worst.chroma ? "T2" : "t", s.worst.test.statistic, twice,
                        once_in(result.false_alarm_rate));
        return;
    }
    verdict.sentence = fmt::format(
        "Agrees with the reference in all {} tests of luminance and colour; a uniform error of "
        "{:.2g} % would have been found.",
        s.tests.size(), 100 * result.detectable_relative_error);
    if (result.second)
        verdict.hints.push_back(fmt::format("A suspicion in {} was not confirmed with fresh seeds.",
                                            to_string(s.worst.region)));
}

// The reference in tiles. A reference without any variance is taken as exact. A reference in which
// only some pixels have no variance, because they have a single sample, is refused.
ReferenceTiles known_tiles(const Image& reference) {
    ReferenceTiles tiles(reference);
    const double unknown = tiles.unknown({0, 0, reference.width, reference.height});
    if (!reference.error.empty() && unknown > 0)
        throw std::invalid_argument(
            fmt::format("{:.0f} pixels of the reference do not know their error, say because they "
                        "have one sample: make it with `raylab reference`",
                        unknown));
    return tiles;
}

} // namespace

IndependentResult judge_independent(const RenderReplicate& render, const Image& reference,
                                    const IndependentOptions& options) {
    IndependentResult result;
    // Renders one stage; false if a replicate is unsound.
    const auto collect = [&](Replicates& replicates, std::uint32_t seed) {
        for (int r = 0; r < options.replicates; ++r) {
            Image image = render(seed + static_cast<std::uint32_t>(r), replicates.spp);
            result.soundness = check_soundness(image, reference.width, reference.height);
            if (!result.soundness.verdict.passed) { // keeps what the first stage measured
                result.verdict = {
                    false, result.soundness.verdict.sentence, {}, result.verdict.measured};
                return false;
            }
            replicates.add(std::move(image));
        }
        return true;
    };

    const ReferenceTiles tiles = known_tiles(reference);
    Replicates first{options.spp, {}, {}};
    if (!collect(first, options.first_seed)) return result;
    bool passed = first_stage(result, first, reference, tiles, options);
    result.false_alarm_rate = options.alpha * options.alpha;
    result.honesty = check_honesty(first, reference);

    if (!passed && !result.honesty.seed_ignored) {
        Replicates second{2 * options.spp, {}, {}};
        if (!collect(second, options.first_seed + static_cast<std::uint32_t>(options.replicates)))
            return result;
        const RegionTest& worst = result.screening.worst;
        const auto again = [&](const Replicates& replicates) {
            return retest(replicates, tiles, reference.provenance.spp, worst.region,
                          worst.direction, options.screening);
        };
        result.second = again(second);
        passed = result.second->p >= options.alpha ||
                 !same_sign(result.second->statistic, again(first).statistic);
        result.honesty = check_honesty(first, reference, &second);
    }
    conclude(result, passed, reference);
    return result;
}

IndependentResult judge_replicates(const Replicates& replicates, const Image& reference,
                                   const IndependentOptions& options) {
    IndependentResult result;
    for (const Image& image : replicates.images) {
        result.soundness = check_soundness(image, reference.width, reference.height);
        if (result.soundness.verdict.passed) continue;
        result.verdict = result.soundness.verdict;
        return result;
    }
    const ReferenceTiles tiles = known_tiles(reference);
    const bool passed = first_stage(result, replicates, reference, tiles, options);
    result.honesty = check_honesty(replicates, reference);
    conclude(result, passed, reference);
    return result;
}

} // namespace raylab
