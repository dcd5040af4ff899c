// Owen-scrambled Sobol points: what the fast forms compute, and how evenly the points lie.
#include "common/sampling/sampler.h"
#include "common/sampling/sobol.h"
#include "common/sampling/tests/statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

namespace raylab {
namespace {

// The definition: x is the sum over bits k of index of direction number v_k, in the field of two
// elements; the second dimension's come from the primitive polynomial x + 1: m_k = 2 m_(k-1) +
// m_(k-1), v_k = m_k / 2^(k+1) (Bratley and Fox, Algorithm 659, 1988).
std::uint32_t sobol_second_by_definition(std::uint32_t index) {
    std::uint32_t m = 1, result = 0;
    for (int k = 0; k < 32; ++k) {
        if (index >> k & 1) result ^= m << (31 - k);
        m = m << 1 ^ m;
    }
    return result;
}

TEST(Sobol, the_butterfly_is_the_generator_matrix) {
    for (std::uint32_t i = 0; i < 70000; ++i)
        ASSERT_EQ(reverse_bits(sobol_second_reversed(i)), sobol_second_by_definition(i)) << i;
    test::Random random(2);
    for (int k = 0; k < 100000; ++k) {
        const std::uint32_t i = pcg4d({std::uint32_t(k), 0, 0, 0}).x;
        ASSERT_EQ(reverse_bits(sobol_second_reversed(i)), sobol_second_by_definition(i)) << i;
    }
}

// Joe and Kuo's recurrence as their paper writes it, for x^2 + x + 1 and x^3 + x + 1:
//     m_k = 2 a_1 m_(k-1) ^ 4 a_2 m_(k-2) ^ ... ^ 2^s m_(k-s) ^ m_(k-s),   v_k = m_k / 2^k.
TEST(Sobol, the_third_and_fourth_direction_numbers_follow_their_polynomials) {
    std::uint64_t third[33] = {0, 1, 3}, fourth[33] = {0, 1, 3, 1};
    for (int k = 3; k <= 32; ++k) third[k] = 2 * third[k - 1] ^ 4 * third[k - 2] ^ third[k - 2];
    for (int k = 4; k <= 32; ++k) fourth[k] = 4 * fourth[k - 2] ^ 8 * fourth[k - 3] ^ fourth[k - 3];
    const DirectionNumbers numbers;
    for (int k = 1; k <= 32; ++k) {
        EXPECT_EQ(reverse_bits(numbers.third[k - 1]), third[k] << (32 - k)) << k;
        EXPECT_EQ(reverse_bits(numbers.fourth[k - 1]), fourth[k] << (32 - k)) << k;
    }
}

TEST(Sobol, reversing_bits_reverses_bits) {
    for (int bit = 0; bit < 32; ++bit) EXPECT_EQ(reverse_bits(1u << bit), 0x80000000u >> bit);
    EXPECT_EQ(reverse_bits(0x12345678u), 0x1e6a2c48u);
}

TEST(Sobol, scrambling_is_nested) {
    // Owen scrambling: a bit may depend on the more significant ones only; here, on the lower ones.
    // And whether it is flipped must not depend on itself, so the scrambling is a permutation.
    for (std::uint32_t k = 0; k < 20000; ++k) {
        const Words w = pcg4d({k, 1, 2, 3});
        const int bit = k % 32;
        const std::uint32_t change =
            owen_scramble_reversed(w.x, w.y) ^ owen_scramble_reversed(w.x ^ 1u << bit, w.y);
        ASSERT_EQ(change & ((2ull << bit) - 1), 1u << bit) << "bit " << bit;
    }
}

// The worst number of points in any elementary interval of a block of 2^m points; 1 for a net.
using Points = std::function<Vec2(std::uint32_t index)>;
int worst_count(const Points& point, std::uint32_t first, int m) {
    const std::uint32_t n = 1u << m;
    int worst = 0;
    for (int a = 0; a <= m; ++a) {
        std::vector<int> boxes(n);
        for (std::uint32_t i = 0; i < n; ++i) {
            const Vec2 p = point(first + i);
            worst = std::max(worst,
                             ++boxes[(int(p.x * (1 << a)) << (m - a)) + int(p.y * (1 << (m - a)))]);
        }
    }
    return worst;
}

// The point in the pixel and the first direction are one point in four dimensions. Two of the first
// four Sobol dimensions make nets of quality t <= 2 at worst: at most 2^t points in a box for one.
TEST(Sobol, film_and_first_direction_are_spread_together) {
    const auto coordinate = [](std::uint32_t i, int d) {
        const Sampler sampler{SamplerKind::sobol, 7, 123, i};
        const Vec2 u = sampler.get_2d(d < 2 ? dimension::film : dimension::first_direction);
        return d % 2 ? u.y : u.x;
    };
    for (int a = 0; a < 4; ++a)
        for (int b = a + 1; b < 4; ++b)
            for (int m = 2; m <= 10; ++m)
                ASSERT_LE(
                    worst_count([&](auto i) { return Vec2(coordinate(i, a), coordinate(i, b)); }, 0,
                                m),
                    4)
                    << "dimensions " << a << ", " << b << ", m " << m;
    // Padded pairs, each in its own order, are spread in themselves alone.
    const auto padded = [](std::uint32_t i) {
        const Sampler sampler{SamplerKind::sobol, 7, 123, i};
        return Vec2(sampler.get_2d(dimension::film).x,
                    sampler.get_2d(bounce_dimension(1, dimension::direction)).x);
    };
    EXPECT_GT(worst_count(padded, 0, 10), 4);
}

TEST(Sampler, a_bounce_has_the_numbers_of_its_pairs) {
    for (const SamplerKind kind : {SamplerKind::sobol, SamplerKind::independent})
        for (std::uint32_t bounce = 0; bounce < 5; ++bounce)
            for (std::uint32_t sample = 0; sample < 100; ++sample) {
                const Sampler sampler{kind, 3, 1000 + bounce, sample};
                const BounceNumbers u = sampler.get_bounce(bounce);
                const auto pair = [&](std::uint32_t decision) {
                    return sampler.get_2d(bounce_dimension(bounce, decision));
                };
                ASSERT_EQ(u.light_point, pair(dimension::light_point));
                ASSERT_EQ(u.light_choice, pair(dimension::light_choice).x);
                ASSERT_EQ(u.direction, pair(dimension::direction));
                ASSERT_EQ(u.lobe, pair(dimension::lobe_roulette).x);
                ASSERT_EQ(u.roulette, pair(dimension::lobe_roulette).y);
            }
}

TEST(Sobol, every_block_of_a_power_of_two_is_a_net) {
    const int largest = test::count(10, 14);
    for (std::uint32_t key = 0; key < 16; ++key) {
        if (key == dimension::first_direction) continue; // dimensions three and four: below
        const Sampler sampler{SamplerKind::sobol, key % 3, key * 77, 0};
        const Points point = [&](std::uint32_t i) {
            Sampler s = sampler;
            s.sample = i;
            return s.get_2d(key);
        };
        for (int m = 0; m <= largest; ++m)
            for (const std::uint32_t block : {0u, 1u, 5u})
                ASSERT_EQ(worst_count(point, block << m, m), 1) << "m " << m << " block " << block;
    }
    // Points that are merely random, or scrambled bit by bit without regard to higher bits, are
    // not.
    EXPECT_GT(worst_count(
                  [](auto i) {
                      return Sampler{SamplerKind::independent, 1, 1, i}.get_2d(0);
                  },
                  0, 8),
              3);
    const auto unnested = [](std::uint32_t i) {
        const std::uint32_t x = reverse_bits(i), y = sobol_second_by_definition(i);
        return Vec2(to_unit(pcg4d({x, 1, 0, 0}).x), to_unit(pcg4d({y, 2, 0, 0}).x));
    };
    EXPECT_GT(worst_count(unnested, 0, 8), 3);
}

// Over keys, every point is uniform: 1e6 keys into 32 x 32 cells. p > 1e-4 for each of 4 indices.
TEST(Sobol, each_point_is_uniform_over_keys) {
    for (const std::uint32_t index : {0u, 1u, 2u, 1000u}) {
        std::vector<double> cells(1024);
        for (std::uint32_t pixel = 0; pixel < 1'000'000; ++pixel) {
            const Vec2 p = Sampler{SamplerKind::sobol, 1, pixel, index}.get_2d(0);
            ++cells[int(p.x * 32) * 32 + int(p.y * 32)];
        }
        EXPECT_GT(test::chi_square_uniform_p(cells), 1e-4) << index;
    }
}

// The integral of a smooth function by 256 points: unbiased (4 standard errors, 6e-5), and with far
// less variance than independent points have; a scrambled net's falls as n^-3 log n, not as n^-1.
TEST(Sobol, a_smooth_integral_converges_faster_and_without_bias) {
    const auto f = [](Vec2 p) { return std::exp(p.x) * std::sin(3 * double(p.y)); };
    const double truth = (M_E - 1) * (1 - std::cos(3.0)) / 3;
    double variance[2];
    for (const SamplerKind kind : {SamplerKind::sobol, SamplerKind::independent}) {
        test::Mean errors;
        for (std::uint32_t pixel = 0; pixel < 1000; ++pixel) {
            double sum = 0;
            for (std::uint32_t i = 0; i < 256; ++i) sum += f(Sampler{kind, 1, pixel, i}.get_2d(6));
            errors.add(sum / 256 - truth);
        }
        // 24-bit points stand for cells and lie at their lower corner: a bias of 2^-25 is their
        // own.
        EXPECT_LT(std::abs(errors.mean()), 4 * errors.standard_error() + 1e-6);
        variance[int(kind)] = errors.sum2 / errors.n;
    }
    const double gain = variance[int(SamplerKind::independent)] / variance[int(SamplerKind::sobol)];
    EXPECT_GT(gain, 1000) << "variance ratio at 256 points";
    RecordProperty("variance_ratio_256", std::to_string(gain));
}

// Padded pairs: within a pixel the halves that x falls into must not tell those of another pair.
// The mean square over pixels of the mean of sign * sign over 16 samples is 1/16 for independent
// pairs, 1/8 for shuffled ones (two neighbours always fall in opposite halves), and 1 without a
// shuffle.
double
tie_between_pairs(const std::function<Vec2(std::uint32_t, std::uint32_t, std::uint32_t)>& at) {
    double sum = 0;
    const int pixels = 10000;
    for (std::uint32_t pixel = 0; pixel < pixels; ++pixel) {
        double mean = 0;
        for (std::uint32_t i = 0; i < 16; ++i)
            mean += (at(pixel, i, 2).x < 0.5f) == (at(pixel, i, 3).x < 0.5f) ? 1 : -1;
        sum += (mean / 16) * (mean / 16);
    }
    return sum / pixels;
}

TEST(Sobol, pairs_are_padded_without_a_tie) {
    const double shuffled = tie_between_pairs([](auto pixel, auto i, auto pair) {
        return Sampler{SamplerKind::sobol, 1, pixel, i}.get_2d(pair);
    });
    EXPECT_NEAR(shuffled, 0.125, 0.01); // standard error 0.0018
    const double unshuffled = tie_between_pairs([](auto pixel, auto i, auto pair) {
        const Words key = pcg4d({1, pixel, pair, 0});
        return Vec2(to_unit(reverse_bits(owen_scramble_reversed(i, key.y))), 0.0f);
    });
    EXPECT_EQ(unshuffled, 1);
}

} // namespace
} // namespace raylab
