// What `raylab compare` decides, what it leaves open, and that no unit of radiance changes it.
#include "common/film/film.h"
#include "grader/judge/compare.h"
#include "grader/judge/tests/simulated.h"

#include <gmock/gmock.h>

#include <limits>

namespace raylab {
namespace {

using namespace simulated;
using testing::HasSubstr;

constexpr int size = 64;

// Replicates as another renderer writes them: without a variance. `filtered`: each pixel is a mean
// over its 3 x 3 neighbourhood, as with a reconstruction filter.
Replicates foreign(int count, std::uint64_t seed, float scale, Noise noise = Noise::pixel,
                   bool filtered = false) {
    Replicates result;
    for (int r = 0; r < count; ++r) {
        Image image = render(size, size, seed * 1000 + std::uint64_t(r), 16, noise,
                             [&](int, int) { return scale; });
        if (filtered) {
            const Image sharp = image;
            for (int y = 1; y + 1 < size; ++y)
                for (int x = 1; x + 1 < size; ++x) {
                    Vec3 sum(0);
                    for (int v = y - 1; v <= y + 1; ++v)
                        for (int u = x - 1; u <= x + 1; ++u) sum += sharp.at(u, v);
                    image.mean[std::size_t(y * size + x)] = sum / 9.0f;
                }
        }
        result.add(std::move(image));
    }
    return result;
}

// One image that knows its error, as raylab renders it.
Image own(std::uint64_t seed, float scale = 1) { return mean_of(foreign(16, seed, scale)); }

Replicates alone(const Image& image) {
    Replicates result;
    result.add(image);
    return result;
}

// Film's way from samples to an image: `spp` of them, uniform around a smooth truth.
Image developed(std::uint64_t seed, int spp, float unit, float scale = 1) {
    Film film(size, size);
    Random random(seed);
    for (int s = 0; s < spp; ++s)
        for (int i = 0; i < size * size; ++i)
            add_sample(film.pixels[std::size_t(i)], unit * scale *
                                                        truth(i % size, i / size, size, size) *
                                                        (Vec3(1) + 0.5f * random.noise()));
    return develop(film);
}

TEST(Compare, ReplicatesTellTheNoiseOfAnotherRenderer) {
    const Image mine = own(1);
    const Comparison right = compare(alone(mine), foreign(2, 2, 1));
    EXPECT_TRUE(right.decided);
    EXPECT_TRUE(right.verdict.passed) << right.verdict.sentence;
    EXPECT_EQ(right.replicates_b, 2);
    const Comparison wrong = compare(alone(mine), foreign(2, 2, 1.01f));
    EXPECT_TRUE(wrong.decided);
    EXPECT_FALSE(wrong.verdict.passed) << "1 % too bright: " << wrong.verdict.sentence;
    EXPECT_FALSE(compare(foreign(2, 1, 1), foreign(2, 2, 1.02f)).verdict.passed);
}

TEST(Compare, WhatIsNotKnownOfTheNoiseIsNotDecided) {
    const Image mine = own(1);
    for (const bool mine_first : {true, false}) {
        const Replicates other = foreign(1, 2, 1);
        const Comparison c = mine_first ? compare(alone(mine), other) : compare(other, alone(mine));
        EXPECT_FALSE(c.decided);
        EXPECT_FALSE(c.verdict.passed);
        EXPECT_THAT(c.verdict.sentence, HasSubstr("carries no variance"));
        EXPECT_THAT(c.verdict.sentence, HasSubstr("--with"));
    }
    EXPECT_FALSE(compare(foreign(1, 1, 1), foreign(1, 2, 1)).decided);
    // Unless it is said that there is none.
    CompareOptions exact;
    exact.exact = true;
    const Comparison c = compare(alone(mine), foreign(1, 2, 1), nullptr, exact);
    EXPECT_TRUE(c.decided);
    EXPECT_FALSE(c.verdict.passed);
    // And what agrees with an image as if that were exact agrees.
    Image truly = mine;
    truly.error.clear();
    for (std::size_t i = 0; i < truly.pixels(); ++i)
        truly.mean[i] = truth(int(i) % size, int(i) / size, size, size);
    EXPECT_TRUE(compare(mine, truly).verdict.passed);
    EXPECT_TRUE(compare(mine, truly).decided);
}

TEST(Compare, OneSampleAPixelTellsNoVariance) {
    const Image one = developed(1, 1, 1), many = developed(2, 64, 1);
    EXPECT_EQ(one.error[0], Vec3(std::numeric_limits<float>::infinity()));
    for (const Comparison& c : {compare(one, many), compare(many, one), compare(one, one)}) {
        EXPECT_EQ(c.decided, c.equal);
        EXPECT_TRUE(std::isfinite(c.metrics().rel_mse));
    }
    EXPECT_THAT(compare(one, many).verdict.sentence, HasSubstr("4096 pixels of the first image"));
    const Comparison open = compare(one, many);
    for (const double z : open.verdict.measured->z_map.z) EXPECT_TRUE(std::isnan(z));
    // Two of them do.
    Replicates two = alone(one);
    two.add(developed(3, 1, 1));
    EXPECT_TRUE(compare(two, alone(many)).verdict.passed);
    EXPECT_FALSE(compare(two, alone(developed(2, 64, 1, 1.1f))).verdict.passed);
    // With a few such pixels, the other regions can still be decided.
    Image mixed = many;
    mixed.error[0] = one.error[0];
    mixed.mean[0] *= 100.0f;
    const Image again = developed(4, 64, 1), bright = developed(4, 64, 1, 1.1f);
    EXPECT_FALSE(compare(mixed, again).decided);
    EXPECT_TRUE(compare(mixed, bright).decided);
    EXPECT_FALSE(compare(mixed, bright).verdict.passed);
    EXPECT_LT(std::abs(compare(mixed, bright).worst_relative), 0.2) << "not the pixel's own tile";
}

// Radiance has no natural unit. Multiplying it by a power of two changes no bit of the verdict and
// of its figures, as long as float can hold the radiance.
TEST(Compare, NoUnitOfRadianceChangesTheVerdict) {
    for (const float scale : {1.0f, 1.1f}) {
        const auto judged = [&](float unit) {
            return compare(developed(1, 16, unit), developed(2, 16, unit, scale));
        };
        const Comparison expected = judged(1);
        EXPECT_EQ(expected.verdict.passed, scale == 1);
        for (int exponent = -100; exponent <= 100; exponent += 20) {
            const Comparison c = judged(std::ldexp(1.0f, exponent));
            EXPECT_EQ(c.verdict.sentence, expected.verdict.sentence) << "2^" << exponent;
            EXPECT_EQ(c.worst.p, expected.worst.p) << "2^" << exponent;
            EXPECT_EQ(c.verdict.measured->z_map.z, expected.verdict.measured->z_map.z)
                << "2^" << exponent;
            EXPECT_EQ(c.metrics().rel_mse, expected.metrics().rel_mse) << "2^" << exponent;
            EXPECT_EQ(c.metrics().rel_bias, expected.metrics().rel_bias) << "2^" << exponent;
        }
    }
}

// Nor does it change tier 2's.
TEST(Independent, NoUnitOfRadianceChangesTheVerdict) {
    const auto judged = [&](float unit) {
        Image known = reference(size, size, 99, Noise::pixel, 16);
        for (auto* pixels : {&known.mean, &known.error})
            for (Vec3& v : *pixels) v *= unit;
        return judge_independent(
            [&](std::uint32_t seed, int spp) {
                return render(size, size, seed, spp, Noise::pixel, [&](int, int) { return unit; });
            },
            known);
    };
    const IndependentResult expected = judged(1);
    for (const int exponent : {-100, -60, 60, 100}) {
        const IndependentResult r = judged(std::ldexp(1.0f, exponent));
        EXPECT_EQ(r.verdict.sentence, expected.verdict.sentence) << "2^" << exponent;
        EXPECT_EQ(r.screening.worst.test.p, expected.screening.worst.test.p) << "2^" << exponent;
        EXPECT_EQ(r.honesty.variance_ratio, expected.honesty.variance_ratio) << "2^" << exponent;
    }
}

TEST(Independent, AReferenceOfOneSampleIsRefused) {
    Image known = reference(size, size, 99, Noise::pixel, 16);
    known.error[7].x = std::numeric_limits<float>::infinity();
    EXPECT_THROW(judge_replicates(replicates(size, size, 1, 16, Noise::pixel), known),
                 std::invalid_argument);
}

// The rate is promised for a thousandth; a hundredth shows itself in fewer gradings. Of `gradings`
// right pairs at a rate of .01 more than 10 are called different with a probability of 7e-6.
TEST(Compare, RightReplicatesAreCalledDifferentAsRarelyAsPromised) {
    constexpr std::uint64_t gradings = 200;
    CompareOptions options;
    options.alpha = 0.01;
    const auto called_different = [&](Noise noise, bool filtered) {
        int count = 0;
        for (std::uint64_t g = 0; g < gradings; ++g)
            count += !compare(foreign(2, 3 * g + 1, 1, noise, filtered),
                              foreign(3, 3 * g + 2, 1, noise, filtered), nullptr, options)
                          .verdict.passed;
        return count;
    };
    EXPECT_LE(called_different(Noise::pixel, false), 10);
    EXPECT_LE(called_different(Noise::stratified, false), 10);
    EXPECT_LE(called_different(Noise::fireflies, false), 10);
    EXPECT_LE(called_different(Noise::pixel, true), 10) << "neighbours that share their noise";
}

} // namespace
} // namespace raylab
