// How often does the judge wrong a correct renderer? Measured, by grading simulated correct
// renders.
//
// Limits are nominal +- 4 standard deviations of the binomial distribution, false-alarm rate 6e-5 a
// test, and the seeds are fixed. RAYLAB_LONG=1 runs 10^4 gradings each.
#include "grader/judge/tests/simulated.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace raylab {
namespace {
using namespace simulated;

constexpr int width = 48, height = 48, spp = 16;

int gradings() { return std::getenv("RAYLAB_LONG") ? 10000 : 2000; }

// Share of gradings in which the first stage rejects at `alpha`.
double rejection_rate(Noise noise, double alpha, const ScreeningOptions& options = {}) {
    int rejected = 0;
    for (int g = 0; g < gradings(); ++g) {
        const Image truth_known = reference(width, height, 77777 + std::uint64_t(g), noise, spp);
        const Screening s = screen(replicates(width, height, 1 + std::uint64_t(g), spp, noise),
                                   ReferenceTiles(truth_known), reference_spp, options);
        rejected += s.worst.test.p < alpha / s.planned;
    }
    return double(rejected) / gradings();
}

double sd(double alpha) { return std::sqrt(alpha * (1 - alpha) / gradings()); }

void print(const char* name, double rate, double alpha) {
    std::printf("    %s: %.2f %% of %d correct renders rejected at nominal %.2f %%\n", name,
                100 * rate, gradings(), 100 * alpha);
}

// Bonferroni over nested regions is a little too strict, hence the half.
void expect_about(const char* name, double rate, double alpha) {
    print(name, rate, alpha);
    EXPECT_GE(rate, alpha / 2 - 4 * sd(alpha));
    EXPECT_LE(rate, alpha + 4 * sd(alpha));
}

void expect_at_most(const char* name, double rate, double alpha) {
    print(name, rate, alpha);
    EXPECT_LE(rate, alpha + 4 * sd(alpha));
}

// The bare test holds its rate...
TEST(Calibration, IndependentPixelsWithoutTheVarianceFloor) {
    expect_about("no floor", rejection_rate(Noise::pixel, 0.1, {1e9, false, 1e-5}), 0.1);
}

// ... and the floor under the variance can only make it more careful.
TEST(Calibration, IndependentPixels) {
    expect_at_most("independent pixels", rejection_rate(Noise::pixel, 0.01), 0.01);
}

TEST(Calibration, PixelsStratifiedAgainstEachOther) {
    expect_at_most("stratified pixels", rejection_rate(Noise::stratified, 0.01), 0.01);
}

TEST(Calibration, PixelsThatShareTheirError) {
    expect_at_most("shared error", rejection_rate(Noise::shared, 0.01), 0.01);
}

TEST(Calibration, FirefliesRejectNoMoreThanNominally) {
    expect_at_most("fireflies", rejection_rate(Noise::fireflies, 0.01), 0.01);
    // Without merging and without the reference's variance the same judge is not calibrated.
    const double naive = rejection_rate(Noise::fireflies, 0.01, {1e9, false, 1e-5});
    print("fireflies, no merging, no floor", naive, 0.01);
    EXPECT_GT(naive, 0.05);
}

// One question, no Bonferroni: p must be uniform, below alpha with probability alpha.
TEST(Calibration, TheSecondStageIsExact) {
    for (const bool floor : {false, true}) {
        int rejected = 0;
        for (int g = 0; g < gradings(); ++g) {
            const auto n = std::uint64_t(g);
            const Image known = reference(width, height, 555 + n, Noise::pixel, spp);
            const Replicates r = replicates(width, height, 90000 + n, spp, Noise::pixel);
            rejected += retest(r, ReferenceTiles(known), reference_spp, {16, 16, 32, 32},
                               DVec3(1, -0.3, 0.2), {3, floor, 1e-5})
                            .p < 0.05;
        }
        const double rate = double(rejected) / gradings();
        print(floor ? "second stage" : "second stage, no floor", rate, 0.05);
        EXPECT_LE(rate, 0.05 + 4 * sd(0.05));
        if (!floor) {
            EXPECT_GE(rate, 0.05 - 4 * sd(0.05));
        }
    }
}

// The variant to avoid takes the error of a tile's mean from the spread of pixels within one image.
double naive_rejection_rate(Noise noise) {
    int rejected = 0;
    const std::vector<Region> regions = regions_of(width, height, tile_size);
    for (int g = 0; g < gradings(); ++g) {
        const Image image = render(width, height, 4321 + std::uint64_t(g), spp, noise);
        bool found = false;
        for (const Region& region : regions) {
            double sum = 0, squares = 0;
            for (int y = region.y0; y < region.y1; ++y)
                for (int x = region.x0; x < region.x1; ++x) {
                    const double d = double(luminance(image.at(x, y))) /
                                         double(luminance(truth(x, y, width, height))) -
                                     1;
                    sum += d;
                    squares += d * d;
                }
            const double n = region.pixels(), mean = sum / n;
            const double variance = (squares / n - mean * mean) / (n - 1);
            found = found || welch_t({mean, variance, n - 1}, {}).p < 0.01 / double(regions.size());
        }
        rejected += found;
    }
    return double(rejected) / gradings();
}

TEST(Calibration, VarianceWithinOneImageIsWrongWherePixelsAreNotIndependent) {
    const double independent = naive_rejection_rate(Noise::pixel);
    const double shared = naive_rejection_rate(Noise::shared);
    const double stratified = naive_rejection_rate(Noise::stratified);
    std::printf("    variance within the image, nominal 1 %%: independent %.2f %%, shared %.2f %%, "
                "stratified %.2f %%\n",
                100 * independent, 100 * shared, 100 * stratified);
    EXPECT_LE(independent, 0.01 + 4 * sd(0.01));
    EXPECT_GT(shared, 0.5) << "fails correct renders";
    EXPECT_EQ(stratified, 0) << "blind: the error is far smaller than it believes";
}

// Light reaches these pixels once in 20000 samples: at 16 spp most tiles see it in a few replicates
// or in none. The reference, with a thousand times the samples, knows the mean well.
TEST(Calibration, TilesThatLightRarelyReaches) {
    constexpr double chance = 1.0 / 20000, value = 1;
    const auto rejected = [&](const ScreeningOptions& options) {
        int count = 0;
        for (int g = 0; g < gradings() / 4; ++g) {
            Random random(31 + std::uint64_t(g));
            Image dark;
            dark.width = dark.height = 32;
            dark.mean.resize(dark.pixels());
            Image known = dark;
            known.mean.assign(dark.pixels(), Vec3(float(value * chance)));
            known.error.assign(dark.pixels(), Vec3(float(std::sqrt(chance / reference_spp))));
            Replicates r{spp, {}, {}};
            for (int k = 0; k < 16; ++k) {
                Image image = dark;
                for (Vec3& v : image.mean)
                    if (random.uniform() < chance * spp) v = Vec3(float(value / spp));
                r.add(image);
            }
            const Screening s = screen(r, ReferenceTiles(known), reference_spp, options);
            count += s.worst.test.p < 0.01 / s.planned;
        }
        return double(count) / (gradings() / 4);
    };
    const double ours = rejected({}), naive = rejected({3, false, 1e-5});
    std::printf("    rarely lit tiles: %.2f %%; without the reference's variance: %.2f %%\n",
                100 * ours, 100 * naive);
    EXPECT_LE(ours, 0.01 + 4 * std::sqrt(0.01 / (gradings() / 4.0)));
    EXPECT_GT(naive, 0.1);
}

} // namespace
} // namespace raylab
