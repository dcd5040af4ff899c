// RNG-CORR: random numbers of neighbouring pixels, samples, dimensions and seeds are unrelated.
#include "common/sampling/sampler.h"
#include "common/sampling/tests/statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

namespace raylab {
namespace {

using test::Correlation;

constexpr SamplerKind both_kinds[] = {SamplerKind::independent, SamplerKind::sobol};

// How a million pairs of numbers are related.
struct Relation {
    double r;      // standard deviation 0.001 if they are not
    double chi2_p; // of their joint histogram, 16 x 16 cells, against all cells alike
};

Relation relation(const std::function<Vec2(std::uint32_t)>& pair_of_numbers) {
    Correlation correlation;
    std::vector<double> cells(256);
    for (std::uint32_t i = 0; i < 1'000'000; ++i) {
        const Vec2 v = pair_of_numbers(i);
        correlation.add(v.x, v.y);
        ++cells[int(v.x * 16) * 16 + int(v.y * 16)];
    }
    return {correlation.r(), test::chi_square_uniform_p(cells)};
}

// False alarms: |r| < 0.005 is 5 standard deviations (6e-7), p in [.001, .999] 2e-3 for a pair of
// families; the seeds are fixed and pass.
void expect_unrelated(const char* what, const Relation& found) {
    EXPECT_LT(std::abs(found.r), 0.005) << what;
    EXPECT_GT(found.chi2_p, 0.001) << what;
    EXPECT_LT(found.chi2_p, 0.999) << what;
}

TEST(RngCorr, numbers_of_neighbouring_keys_are_unrelated) {
    for (const SamplerKind kind : both_kinds) {
        SCOPED_TRACE(kind == SamplerKind::sobol ? "sobol" : "independent");
        const auto at = [&](std::uint32_t seed, std::uint32_t pixel, std::uint32_t sample,
                            std::uint32_t pair) {
            return Sampler{kind, seed, pixel, sample}.get_2d(pair);
        };
        const auto x = [&](auto... key) { return at(key...).x; };
        expect_unrelated("u1, u2", relation([&](auto i) { return at(1, i, 0, 2); }));
        expect_unrelated("pixel to pixel", relation([&](auto i) {
                             return Vec2(x(1u, i, 0u, 2u), x(1u, i + 1, 0u, 2u));
                         }));
        expect_unrelated("row to row", relation([&](auto i) {
                             return Vec2(x(1u, i, 0u, 2u), x(1u, i + 640, 0u, 2u));
                         }));
        expect_unrelated("pair to pair", relation([&](auto i) {
                             return Vec2(x(1u, i, 0u, 4u), x(1u, i, 0u, 5u));
                         }));
        expect_unrelated("bounce to bounce", relation([&](auto i) {
                             return Vec2(x(1u, i, 3u, 4u), x(1u, i, 3u, 8u));
                         }));
        expect_unrelated("seed to seed", relation([&](auto i) {
                             return Vec2(x(1u, i, 0u, 2u), x(2u, i, 0u, 2u));
                         }));
        expect_unrelated("pixel and seed exchanged", relation([&](auto i) {
                             return Vec2(x(1u, i, 0u, 2u), x(i, 1u, 0u, 2u));
                         }));
        expect_unrelated("late samples",
                         relation([&](auto i) { return at(1, i, 4'194'304 + 1, 2); }));
    }
    // Samples of one pixel: unrelated if independent, evenly spread if Sobol (sobol_test.cpp).
    const auto sample = [](std::uint32_t i) {
        return Sampler{SamplerKind::independent, 1, 12345, i}.get_2d(2);
    };
    expect_unrelated("sample to sample",
                     relation([&](auto i) { return Vec2(sample(i).x, sample(i + 1).x); }));
    expect_unrelated("u1, u2 over samples", relation(sample));
}

TEST(RngCorr, a_raw_seed_and_wang_hash_are_caught) {
    // One step of a congruential generator seeded with the pixel: neighbours differ by a constant.
    const auto lcg = [](std::uint32_t pixel) { return to_unit(pixel * 1664525u + 1013904223u); };
    const Relation raw = relation([&](auto i) { return Vec2(lcg(i), lcg(i + 1)); });
    EXPECT_GT(raw.r, 0.9) << "the test no longer sees correlated pixels";

    // Wang's hash, the usual seed of student kernels.
    const auto wang = [](std::uint32_t x) {
        x = (x ^ 61u) ^ (x >> 16);
        x *= 9u;
        x ^= x >> 4;
        x *= 0x27d4eb2du;
        return x ^ (x >> 15);
    };
    const Relation w =
        relation([&](auto i) { return Vec2(to_unit(wang(i)), to_unit(wang(i + 1))); });
    EXPECT_LT(std::min(w.chi2_p, 1 - w.chi2_p), 0.001) << "the test no longer sees Wang's hash";
    RecordProperty("lcg_r", std::to_string(raw.r));
    RecordProperty("wang_r", std::to_string(w.r));
    RecordProperty("wang_chi2_p", std::to_string(w.chi2_p));
}

// pcg4d: flipping one bit of the input flips each output bit of the upper 24 with probability 1/2.
// Without the shift before the first round bits 25 to 31 of each word fail.
// 128 * 48 frequencies over 4096 keys, standard deviation 1/128; the worst of 6144 should stay
// below 6 of them (false alarm 1e-5).
TEST(RngCorr, one_bit_of_the_key_changes_half_of_the_bits) {
    test::Random random(1);
    const int keys = 4096;
    double worst = 0;
    for (int bit = 0; bit < 128; ++bit) {
        int flips[48] = {};
        for (int k = 0; k < keys; ++k) {
            // Small numbers, as seeds, pixels, pairs and samples are.
            std::uint32_t v[4] = {std::uint32_t(random.u() * 4), std::uint32_t(random.u() * 65536),
                                  std::uint32_t(random.u() * 64), std::uint32_t(random.u() * 256)};
            const Words a = pcg4d({v[0], v[1], v[2], v[3]});
            v[bit / 32] ^= 1u << bit % 32;
            const Words b = pcg4d({v[0], v[1], v[2], v[3]});
            for (int i = 0; i < 24; ++i) {
                flips[i] += (a.x ^ b.x) >> (8 + i) & 1;
                flips[24 + i] += (a.y ^ b.y) >> (8 + i) & 1;
            }
        }
        for (int f : flips) worst = std::max(worst, std::abs(double(f) / keys - 0.5));
    }
    EXPECT_LT(worst, 6.0 / 128);
}

TEST(Sampler, never_returns_one) {
    EXPECT_EQ(to_unit(0xffffffffu), one_minus_epsilon);
    EXPECT_EQ(to_unit(0), 0.0f);
    EXPECT_EQ(float(0xffffffffu) * 0x1p-32f, 1.0f) << "what the usual conversion does";
}

} // namespace
} // namespace raylab
