// Errors of images whose truth is known.
#include "grader/bench/error.h"
#include "grader/judge/tests/simulated.h"

#include <gtest/gtest.h>

namespace raylab::bench {
namespace {

using simulated::Noise;

constexpr int size = 128;

// E mse of a render of `spp` samples: mean of truth^2 var / spp over pixels and channels.
double true_mse(int spp) {
    const Vec3 variance = simulated::sample_variance(Noise::pixel, spp);
    double sum = 0;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const Vec3 t = simulated::truth(x, y, size, size);
            for (int c = 0; c < 3; ++c) sum += double(t[c]) * t[c] * variance[c] / spp;
        }
    return sum / (3.0 * size * size);
}

// A reference with no more samples than the render, which its standard error shows.
Image noisy_reference(int spp) {
    Image reference = simulated::render(size, size, 99, spp, Noise::pixel);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const Vec3 t = simulated::truth(x, y, size, size);
            reference.error.push_back(
                t * glm::sqrt(simulated::sample_variance(Noise::pixel, spp) / float(spp)));
        }
    return reference;
}

TEST(ErrorAgainst, TakesTheReferencesOwnVarianceOff) {
    const Image render = simulated::render(size, size, 1, 16, Noise::pixel);
    Image reference = noisy_reference(16);
    const double expected = true_mse(16);
    EXPECT_NEAR(error_against(render, reference).mse / expected, 1, 0.04);
    reference.error.clear(); // what the plain formula gives: twice too much
    EXPECT_NEAR(error_against(render, reference).mse / expected, 2, 0.08);
}

TEST(ErrorAgainst, IsRelativeToTheReferencesLevel) {
    const Image render = simulated::render(size, size, 1, 16, Noise::pixel);
    const Image reference = simulated::reference(size, size, 5, Noise::pixel, 16);
    // Relative noise is cv^2 (1.69, .97, .97) / spp in every pixel; 1 % of the mean does not
    // matter.
    const double expected = double(simulated::cv) * simulated::cv * (1.69 + 2 * 0.97) / 3 / 16;
    EXPECT_NEAR(error_against(render, reference).rel_mse / expected, 1, 0.04);
    EXPECT_NEAR(error_against(render, reference).rel_mse, measure(render, reference).rel_mse, 1e-9);
}

TEST(ErrorOfPair, IsTheVarianceOfOneWithoutKnowingTheTruth) {
    const Image a = simulated::render(size, size, 1, 16, Noise::pixel);
    const Image b = simulated::render(size, size, 2, 16, Noise::pixel);
    EXPECT_NEAR(error_of_pair(a, b, a).mse / true_mse(16), 1, 0.04);
    EXPECT_EQ(error_of_pair(a, a, a).mse, 0);
}

// Sixteen renders too bright by 1 %: the interval holds 1 %, and not 0.
TEST(BiasOf, FindsAnEvenError) {
    const Image reference = simulated::reference(size, size, 5, Noise::pixel, 16);
    std::vector<Image> renders;
    for (std::uint64_t seed = 0; seed < 16; ++seed)
        renders.push_back(
            simulated::render(size, size, seed, 16, Noise::pixel, [](int, int) { return 1.01f; }));
    std::vector<const Image*> all;
    for (const Image& image : renders) all.push_back(&image);
    const Bias bias = bias_of(all, reference);
    EXPECT_NEAR(bias.relative, 0.01, 2 * bias.half_width_95);
    EXPECT_GT(bias.relative - bias.half_width_999, 0);
    EXPECT_LT(bias.half_width_95, bias.half_width_999);
}

TEST(Errors, LeaveOutWhatIsNotFiniteAndRefuseOtherSizes) {
    Image a = simulated::render(size, size, 1, 16, Noise::pixel);
    const Image b = simulated::render(size, size, 2, 16, Noise::pixel);
    a.mean[7] = Vec3(NAN);
    EXPECT_NEAR(error_of_pair(a, b, b).mse / true_mse(16), 1, 0.04);
    EXPECT_THROW(error_against(simulated::render(8, 8, 1, 1, Noise::pixel), b),
                 std::invalid_argument);
}

} // namespace
} // namespace raylab::bench
