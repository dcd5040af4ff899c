// What the judge must find, and what weaker judges miss.
#include "grader/judge/compare.h"
#include "grader/judge/tests/simulated.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace raylab {
namespace {
using namespace simulated;
using testing::HasSubstr;

constexpr int side = 128;

// Judges renders whose truth is multiplied by scale(x, y), 16 replicates of 16 spp.
template <class Scale>
IndependentResult judge(Scale scale, int spp = 16, Noise noise = Noise::pixel,
                        std::uint32_t first_seed = 1) {
    IndependentOptions options;
    options.spp = spp;
    options.first_seed = first_seed;
    return judge_independent(
        [&](std::uint32_t seed, int n) { return render(side, side, seed, n, noise, scale); },
        reference(side, side, 99, noise, spp), options);
}

const auto correct = [](int, int) { return 1.0f; };

TEST(Power, ACorrectRenderPasses) {
    for (std::uint32_t seed = 0; seed < 20; ++seed) {
        const IndependentResult r = judge(correct, 16, Noise::pixel, 100 * seed);
        EXPECT_TRUE(r.verdict.passed) << r.verdict.sentence;
        EXPECT_THAT(r.verdict.sentence, HasSubstr("Agrees with the reference"));
        EXPECT_LT(r.detectable_relative_error, 0.004);
        EXPECT_LT(r.verdict.measured->metrics.rel_bias, 0.01);
    }
}

TEST(Power, OnePercentTooBrightIsFoundEveryTime) {
    for (std::uint32_t seed = 0; seed < 20; ++seed) {
        const auto r = judge([](int, int) { return 1.01f; }, 16, Noise::pixel, 100 * seed);
        EXPECT_FALSE(r.verdict.passed);
        ASSERT_TRUE(r.second.has_value());
        EXPECT_GT(r.second->statistic, 0);
        EXPECT_THAT(r.verdict.sentence, HasSubstr("too bright"));
    }
}

TEST(Power, ASuspicionThatFreshSeedsTurnRoundIsNotBelieved) {
    const Image known = reference(side, side, 99, Noise::pixel, 16);
    const auto r = judge_independent(
        [&](std::uint32_t seed, int spp) {
            const float scale = seed <= 16 ? 1.02f : 0.98f; // seeds 1 to 16: the first stage
            return render(side, side, seed, spp, Noise::pixel, [&](int, int) { return scale; });
        },
        known);
    ASSERT_TRUE(r.second.has_value());
    EXPECT_LT(r.second->statistic, -5);
    ASSERT_TRUE(r.verdict.passed) << r.verdict.sentence;
    EXPECT_THAT(r.verdict.hints.back(), HasSubstr("not confirmed"));
}

TEST(Power, AReferenceThatIsTooNoisyIsSaid) {
    Image known = reference(side, side, 99, Noise::pixel, 16);
    for (Vec3& v : known.error) v *= 8.0f;
    known.provenance.spp /= 64;
    const auto r = judge_replicates(replicates(side, side, 1, 16, Noise::pixel), known);
    EXPECT_THAT(r.verdict.hints.at(0), HasSubstr("the reference's own"));
}

// An error of 1 % at c = 0.5 needs about 145 samples a pixel in a square of 2 x 2 tiles. Here it is
// confined to one such square, with 256 samples in the first stage.
TEST(Power, OnePercentInOneBlockIsFound) {
    int found = 0;
    for (std::uint32_t seed = 0; seed < 10; ++seed)
        found += !judge([](int x, int y) { return x / 32 == 1 && y / 32 == 2 ? 1.01f : 1.0f; }, 16,
                        Noise::pixel, 100 * seed)
                      .verdict.passed;
    EXPECT_GE(found, 9);
}

double rmse(const Image& a, const Image& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.pixels(); ++i)
        sum += double(length_squared(a.mean[i] - b.mean[i])) / 3;
    return std::sqrt(sum / double(a.pixels()));
}

TEST(Power, OneWrongAlbedoIsFoundThoughTheWholeImageErrorDoesNotSeeIt) {
    // A patch of 12 x 12 pixels, 6 % too dark.
    const auto patch = [](int x, int y) {
        return x >= 50 && x < 62 && y >= 70 && y < 82 ? 0.94f : 1.0f;
    };
    const auto result = judge(patch);
    EXPECT_FALSE(result.verdict.passed);
    EXPECT_THAT(result.verdict.sentence, HasSubstr("too dark"));
    const Region& r = result.screening.worst.region;
    EXPECT_TRUE(r.x0 < 62 && r.x1 > 50 && r.y0 < 82 && r.y1 > 70) << to_string(r);

    const Image known = reference(side, side, 99, Noise::pixel, 16);
    double largest = 0;
    for (std::uint64_t seed = 1; seed <= 16; ++seed)
        largest = std::max(largest, rmse(render(side, side, seed, 16, Noise::pixel), known));
    const double wrong = rmse(render(side, side, 17, 16, Noise::pixel, patch), known);
    std::printf("    wrong albedo: t = %.1f; whole-image RMSE %.5f, correct renders up to %.5f\n",
                result.screening.worst.test.statistic, wrong, largest);
    EXPECT_LT(wrong, largest);
}

// +1 % red and -1 % blue: luminance hardly moves, and each channel alone drowns in noise that the
// channels share; their difference does not.
TEST(Power, AColourShiftIsFoundByHotellingAndMissedChannelByChannel) {
    const auto shift = [](int, int) { return Vec3(1.01f, 1, 0.99f); };
    // Noise that is almost grey, 40 spp in all.
    const auto grey = [&](std::uint64_t seed, int spp, bool wrong) {
        Image image = render(side, side, seed, spp, Noise::pixel);
        Random random(seed);
        for (std::size_t i = 0; i < image.pixels(); ++i) {
            const Vec3 t = truth(int(i) % side, int(i) / side, side, side);
            const Vec3 n = random.noise();
            image.mean[i] = t * (Vec3(1) + 4.0f / std::sqrt(float(spp)) * (Vec3(n.x) + 0.05f * n)) *
                            (wrong ? shift(0, 0) : Vec3(1));
        }
        return image;
    };
    const Image known = reference(side, side, 99, Noise::pixel, 16);
    int by_chroma = 0, by_channel = 0, false_alarms = 0;
    for (std::uint64_t g = 0; g < 20; ++g) {
        for (const bool wrong : {false, true}) {
            Replicates r{16, {}, {}};
            for (std::uint64_t k = 0; k < 16; ++k) r.add(grey(1000 * g + k + 1, 16, wrong));
            const ReferenceTiles tiles(known);
            const Screening s = screen(r, tiles, reference_spp);
            const bool found = s.worst.test.p < 5e-4 / s.planned;
            (wrong ? by_chroma : false_alarms) += found;
            if (!wrong) continue;
            EXPECT_TRUE(!found || s.worst.chroma);
            bool channel = false;
            for (const RegionTest& test : s.tests)
                for (int c = 0; c < 3; ++c) {
                    DVec3 axis(0);
                    axis[c] = 1;
                    channel = channel || retest(r, tiles, reference_spp, test.region, axis).p <
                                             5e-4 / (1.5 * s.planned);
                }
            by_channel += channel;
        }
    }
    std::printf("    +1 %% R, -1 %% B: found by chroma %d of 20, channel by channel %d of 20\n",
                by_chroma, by_channel);
    EXPECT_EQ(by_chroma, 20);
    EXPECT_LE(by_channel, 2);
    EXPECT_EQ(false_alarms, 0);
}

// Mitsuba 3's way: a z-test a pixel with the variance from the reference's samples alone, Sidak
// over all pixels at 1 %, passed if at most 0.25 % of the pixels are rejected.
bool passes_pixel_by_pixel(const Image& image, const Image& known, int spp) {
    const double alpha = 1 - std::pow(0.99, 1.0 / (3 * double(known.pixels())));
    int rejected = 0;
    for (std::size_t i = 0; i < known.pixels(); ++i)
        for (int c = 0; c < 3; ++c) {
            const double sigma = known.error[i][c] * std::sqrt(double(reference_spp) / spp);
            const double z = (double(image.mean[i][c]) - double(known.mean[i][c])) / sigma;
            rejected += std::erfc(std::abs(z) / std::sqrt(2.0)) < alpha;
        }
    return rejected <= 0.0025 * 3 * double(known.pixels());
}

TEST(Power, TwentyPercentTooBrightPassesPixelByPixelAndFailsHere) {
    const auto bright = [](int, int) { return 1.2f; };
    constexpr int spp = 16;
    const Image known = reference(side, side, 99, Noise::pixel, spp);
    EXPECT_TRUE(
        passes_pixel_by_pixel(render(side, side, 1, spp, Noise::pixel, bright), known, spp));
    const auto result = judge(bright);
    EXPECT_FALSE(result.verdict.passed);
    EXPECT_NEAR(result.verdict.measured->metrics.rel_error, 0.2, 0.005);
    EXPECT_NEAR(result.verdict.measured->metrics.rel_bias, 0.2, 0.02);
}

TEST(Honesty, AnIgnoredSeedFails) {
    IndependentOptions options;
    const Image known = reference(side, side, 99, Noise::pixel, 16);
    const auto r = judge_independent(
        [&](std::uint32_t, int spp) { return render(side, side, 7, spp, Noise::pixel); }, known,
        options);
    EXPECT_FALSE(r.verdict.passed);
    EXPECT_TRUE(r.honesty.seed_ignored);
    EXPECT_THAT(r.verdict.sentence, HasSubstr("seed is ignored"));
}

TEST(Honesty, AnImageWithoutNoiseMayBeEqualForAllSeeds) {
    Image known = render(side, side, 1, 1, Noise::pixel);
    for (std::size_t i = 0; i < known.pixels(); ++i)
        known.mean[i] = truth(int(i) % side, int(i) / side, side, side);
    known.error.assign(known.pixels(), Vec3(0));
    const Image exact = known;
    auto r = judge_independent([&](std::uint32_t, int) { return exact; }, known);
    EXPECT_TRUE(r.verdict.passed) << r.verdict.sentence;
    Image wrong = exact;
    wrong.mean[5000].y *= 1.05f; // one pixel, with no noise to hide in
    r = judge_independent([&](std::uint32_t, int) { return wrong; }, known);
    EXPECT_FALSE(r.verdict.passed) << r.verdict.sentence;
}

TEST(Honesty, SharedNoiseIsMeasured) {
    const Image known = reference(side, side, 99, Noise::pixel, 16);
    // Half of the variance does not depend on the seed.
    const auto half = [&](std::uint32_t seed, int spp) {
        Image a = render(side, side, seed, spp, Noise::pixel);
        const Image b = render(side, side, 1234, spp, Noise::pixel);
        for (std::size_t i = 0; i < a.pixels(); ++i)
            a.mean[i] =
                known.mean[i] + std::sqrt(0.5f) * (a.mean[i] + b.mean[i] - 2.0f * known.mean[i]);
        return a;
    };
    Replicates r{16, {}, {}}, independent{16, {}, {}};
    for (std::uint32_t seed = 1; seed <= 16; ++seed) {
        r.add(half(seed, 16));
        independent.add(render(side, side, seed, 16, Noise::pixel));
    }
    EXPECT_NEAR(check_honesty(r, known).replicate_correlation, 0.5, 0.05);
    EXPECT_NEAR(check_honesty(independent, known).replicate_correlation, 0, 0.02);
}

TEST(Honesty, VarianceIsComparedWithTheReferenceAndWithTwiceTheSamples) {
    const Image known = reference(side, side, 99, Noise::pixel, 16);
    const Replicates first = replicates(side, side, 1, 16, Noise::pixel);
    const Replicates second = replicates(side, side, 2, 32, Noise::pixel);
    const Honesty honest = check_honesty(first, known, &second);
    EXPECT_NEAR(*honest.variance_ratio, 1, 0.1);
    EXPECT_NEAR(*honest.variance_fall, 2, 0.2);
    EXPECT_NEAR(honest.tile_ratio, 1, 0.3);
    EXPECT_TRUE(honest.hints.empty());

    // Replicates that say how many samples they have give no hint. Replicates of 80 and of 3
    // samples that claim 16 have too little noise and too much.
    EXPECT_EQ(check_honesty(replicates(side, side, 3, 16 * 5, Noise::pixel), known).hints.size(),
              0u);
    Replicates cached = replicates(side, side, 3, 16 * 5, Noise::pixel),
               lazy = replicates(side, side, 3, 3, Noise::pixel);
    cached.spp = lazy.spp = 16;
    EXPECT_THAT(check_honesty(cached, known).hints.at(0), HasSubstr("denoised"));
    EXPECT_THAT(check_honesty(lazy, known).hints.at(0), HasSubstr("technique missing"));
    EXPECT_GT(check_honesty(replicates(side, side, 5, 16, Noise::shared), known).tile_ratio, 4);
}

TEST(Soundness, AnImageOfNanFails) {
    const Image known = reference(side, side, 99, Noise::pixel, 16);
    const auto r = judge_independent(
        [&](std::uint32_t seed, int spp) {
            Image image = render(side, side, seed, spp, Noise::pixel);
            image.mean.assign(image.pixels(), Vec3(std::numeric_limits<float>::quiet_NaN()));
            return image;
        },
        known);
    EXPECT_FALSE(r.verdict.passed);
    EXPECT_EQ(r.soundness.not_finite, known.pixels());
    EXPECT_THAT(r.verdict.sentence, HasSubstr("16384 are NaN"));
}

TEST(Compare, TwoRendersOfTheSameSceneAreConsistentAndAnErrorIsFound) {
    const auto with_variance = [](std::uint64_t seed, float scale) {
        return mean_of([&] {
            Replicates r{16, {}, {}};
            for (std::uint64_t k = 0; k < 16; ++k)
                r.add(render(64, 64, seed * 100 + k, 16, Noise::pixel,
                             [&](int, int) { return scale; }));
            return r;
        }());
    };
    int called_different = 0;
    for (std::uint64_t g = 0; g < 100; ++g)
        called_different +=
            !compare(with_variance(2 * g, 1), with_variance(2 * g + 1, 1)).verdict.passed;
    EXPECT_LE(called_different, 2)
        << "of 100 at a rate of 1e-3: more than 2 has probability 1.5e-4";

    const Image a = with_variance(1, 1), b = with_variance(2, 1.02f);
    const Comparison c = compare(a, b);
    EXPECT_TRUE(c.decided);
    EXPECT_FALSE(c.verdict.passed) << c.verdict.sentence;
    EXPECT_LT(c.worst.statistic, 0);
    EXPECT_TRUE(compare(a, a).equal);
}

TEST(Metrics, MeetTheirClosedForms) {
    Image r = render(32, 32, 1, 1, Noise::pixel);
    r.mean.assign(r.pixels(), Vec3(2));
    Image a = r;
    a.mean.assign(a.pixels(), Vec3(3));
    r.error.assign(r.pixels(), Vec3(0.5f));
    a.error.assign(a.pixels(), Vec3(0.375f));
    const Metrics m = measure(a, r);
    EXPECT_DOUBLE_EQ(m.mse, 1);
    EXPECT_NEAR(m.rel_mse, (1 - 0.25) / (4 + 1e-4 * 4), 1e-12);
    EXPECT_NEAR(m.rel_error, 0.5, 1e-12);
    EXPECT_NEAR(m.rel_bias, std::sqrt(1 - 0.390625) / 2, 1e-7);
    // 256 pixels a tile: z = 1 / sqrt(0.390625 / 256).
    const ZMap z = z_map(a, r);
    ASSERT_EQ(z.z.size(), 4u);
    for (const double v : z.z) EXPECT_NEAR(v, 16 / 0.625, 1e-9);
}

} // namespace
} // namespace raylab
