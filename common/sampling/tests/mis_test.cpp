// MIS-EXT: the power heuristic has its limits at densities of 0, 1e-30, 1, 1e30 and infinity.
#include "common/math/numbers.h"
#include "common/sampling/mis.h"

#include <gtest/gtest.h>

#include <cmath>

namespace raylab {
namespace {

constexpr float densities[] = {0, 1e-30f, 1, 1e30f, infinity};

TEST(MisExt, weights_are_in_the_unit_interval_and_sum_to_one) {
    int naive_nans = 0;
    for (const float f : densities)
        for (const float g : densities) {
            const float w_f = power_heuristic(f, g), w_g = power_heuristic(g, f);
            EXPECT_TRUE(w_f >= 0 && w_f <= 1) << f << " against " << g << ": " << w_f;
            EXPECT_NEAR(w_f + w_g, 1, 1e-7) << f << " against " << g;
            naive_nans += std::isnan(f * f / (f * f + g * g));
        }
    EXPECT_GE(naive_nans, 7) << "f^2 / (f^2 + g^2) should fail here";
    RecordProperty("naive_nans_of_25", naive_nans);
}

TEST(MisExt, weights_have_the_right_limits) {
    EXPECT_EQ(power_heuristic(1, 0), 1);
    EXPECT_EQ(power_heuristic(infinity, 1), 1); // a delta lobe that happens to meet a light
    EXPECT_EQ(power_heuristic(1, infinity), 0);
    EXPECT_EQ(power_heuristic(1e30f, 1e-30f), 1);
    EXPECT_EQ(power_heuristic(1e-30f, 1e30f), 0);
    EXPECT_EQ(power_heuristic(infinity, infinity), 0.5f);
    EXPECT_FLOAT_EQ(power_heuristic(3, 4), 9.0f / 25);
    EXPECT_FLOAT_EQ(power_heuristic(3e30f, 4e30f), 9.0f / 25);   // squares overflow
    EXPECT_FLOAT_EQ(power_heuristic(3e-30f, 4e-30f), 9.0f / 25); // squares vanish
}

} // namespace
} // namespace raylab
