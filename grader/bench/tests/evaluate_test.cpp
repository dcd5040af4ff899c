// Turns, figures and the error check, with contestants whose speed and noise are known.
#include "grader/bench/tests/simulated_contestant.h"

#include <gmock/gmock.h>

#include <map>
#include <set>

namespace raylab::bench {
namespace {

using simulated_bench::contestant;
using simulated_bench::Habits;
using simulated_bench::rows_of;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(TakeTurns, EverybodyBeginsInTurnAndNoSeedIsUsedTwice) {
    std::vector<std::string> order;
    std::set<std::uint32_t> seeds;
    const auto watched = [&](const std::string& name) {
        return Contestant{name, "", [&order, &seeds, name](int spp, std::uint32_t seed) {
                              order.push_back(name + std::to_string(spp));
                              seeds.insert(seed);
                              return Drawn{};
                          }};
    };
    take_turns({watched("a"), watched("b")}, {{1, 2}, 2, 7});
    EXPECT_THAT(order, ElementsAre("a1", "b1", "a1", "b1", "a2", "b2", "b1", "a1", "b2", "a2"));
    EXPECT_EQ(seeds.size(), order.size());
    EXPECT_EQ(*seeds.begin(), 7u);
}

TEST(Evaluate, FindsStartUpSlopeErrorAndRatio) {
    const auto rows =
        rows_of({contestant("slow", {1, 0.1}), contestant("fast", {5, 0.025})}, "slow");
    EXPECT_NEAR(rows[0].ms_per_spp.median, 100, 1e-9);
    EXPECT_NEAR(rows[0].start_up.median, 1, 1e-9);
    EXPECT_NEAR(rows[1].start_up.median, 5, 1e-9);
    EXPECT_TRUE(rows[0].is_baseline);
    ASSERT_TRUE(rows[1].speed_ratio && rows[1].efficiency_ratio);
    EXPECT_NEAR(rows[1].speed_ratio->median, 4, 1e-9);
    EXPECT_NEAR(rows[1].efficiency_ratio->median, 4, 0.4);
    EXPECT_EQ(rows[0].efficiency_ratio->median, 1);
    // relMSE is cv^2 (1.69 + .97 + .97) / 3 / spp = .3025 / spp: .01 is reached at 30 samples.
    EXPECT_NEAR(rows[0].rel_mse.median, 0.3025 / 64, 0.1 * 0.3025 / 64);
    EXPECT_NEAR(rows[0].seconds_to_target.median, 3.025, 0.3);
    EXPECT_NEAR(rows[0].exponent.median, -1, 0.1);
    EXPECT_THAT(rows[1].remarks, IsEmpty());
}

// The error measured from a reference is the same, even if the reference is no better than the
// render.
TEST(Evaluate, ErrorsFromAReferenceAndFromPairsAreTheSame) {
    const Image reference = raylab::simulated::reference(
        simulated_bench::size, simulated_bench::size, 5, raylab::simulated::Noise::pixel, 64);
    const auto from_reference = rows_of({contestant("a", {})}, "a", &reference);
    const auto from_pairs = rows_of({contestant("a", {})}, "a");
    EXPECT_NEAR(from_reference[0].mse.median / from_pairs[0].mse.median, 1, 0.1);
    EXPECT_TRUE(from_reference[0].agrees) << from_reference[0].verdict;
    EXPECT_LT(std::abs(from_reference[0].bias.relative), 0.01);
    EXPECT_TRUE(std::isnan(from_pairs[0].bias.relative));
}

TEST(Evaluate, AWrongImageGetsNoRatio) {
    const auto rows =
        rows_of({contestant("right", {}), contestant("dark", {1, 0.001, 0.95f})}, "right");
    EXPECT_TRUE(rows[0].agrees);
    EXPECT_FALSE(rows[1].agrees);
    EXPECT_FALSE(rows[1].speed_ratio || rows[1].efficiency_ratio);
    EXPECT_THAT(rows[1].verdict, AllOf(HasSubstr("images differ"), HasSubstr("too dark by 4.9")));
}

TEST(Evaluate, AWrongBaselineLeavesNoRatioAtAll) {
    const auto rows =
        rows_of({contestant("right", {}), contestant("dark", {1, 0.001, 0.95f})}, "dark");
    for (const Row& row : rows) EXPECT_FALSE(row.speed_ratio || row.efficiency_ratio);
}

TEST(Evaluate, AnImageOfAnotherSizeDiffers) {
    const Contestant small = {"small", "", [](int spp, std::uint32_t seed) {
                                  Drawn drawn;
                                  drawn.image = raylab::simulated::render(
                                      8, 8, seed, spp, raylab::simulated::Noise::pixel);
                                  drawn.seconds = spp;
                                  return drawn;
                              }};
    const auto rows = rows_of({contestant("right", {}), small}, "right");
    EXPECT_THAT(rows[1].verdict, HasSubstr("images differ: its size is 8 x 8, not 48 x 48"));
    EXPECT_FALSE(rows[1].speed_ratio);
}

TEST(Evaluate, WhoFailsSaysSoAndTheOthersGoOn) {
    int calls = 0;
    const Contestant broken = {"broken", "", [&calls](int, std::uint32_t) -> Drawn {
                                   ++calls;
                                   throw ContestantError("failed: no reason");
                               }};
    const auto rows = rows_of({broken, contestant("right", {}), contestant("other", {})}, "right");
    EXPECT_EQ(rows[0].failure, "failed: no reason");
    EXPECT_EQ(calls, 1);
    EXPECT_TRUE(rows[1].agrees && rows[2].agrees);
    EXPECT_TRUE(rows[2].efficiency_ratio);
}

// A load that comes and goes multiplies the time of a whole round: seconds move, ratios do not.
TEST(Evaluate, RatiosAreFormedWithinARound) {
    int runs = -2; // the first two are not timed
    const auto loaded = [&](const std::string& name, double seconds) {
        Contestant c = contestant(name, {0, seconds});
        return Contestant{name, "", [&runs, c](int spp, std::uint32_t seed) {
                              Drawn drawn = c.render(spp, seed);
                              drawn.seconds *=
                                  1 + runs++ / 2 / 2; // 2 contestants x 2 counts a round
                              return drawn;
                          }};
    };
    const auto rows = rows_of({loaded("a", 0.1), loaded("b", 0.05)}, "a");
    EXPECT_GT(rows[0].ms_per_spp.high, 4 * rows[0].ms_per_spp.low);
    EXPECT_NEAR(rows[1].speed_ratio->low, 2, 1e-9);
    EXPECT_NEAR(rows[1].speed_ratio->high, 2, 1e-9);
}

TEST(Evaluate, SaysWhenTheFitDoesNotHold) {
    const auto rows = rows_of({contestant("sobol", {1, 0.1, 1, -1.4})}, "sobol");
    EXPECT_NEAR(rows[0].exponent.median, -1.4, 0.15);
    EXPECT_THAT(rows[0].remarks, ElementsAre(HasSubstr("falls as n^-1.")));
}

// In the first `disturbed` of 5 rounds, few samples take longer than many. In the other rounds a
// sample takes 100, 101, ... ms.
std::vector<Row> rows_with_disturbed_rounds(int disturbed, const std::string& baseline) {
    int runs = -1; // the first is not timed
    const Contestant c = contestant("a", {});
    const Contestant watched = {"a", "", [&runs, disturbed, c](int spp, std::uint32_t seed) {
                                    Drawn drawn = c.render(spp, seed);
                                    const int round = runs++ / 2;
                                    drawn.seconds = round < disturbed ? 10 - 0.1 * spp
                                                                      : (0.1 + 0.001 * round) * spp;
                                    return drawn;
                                }};
    return rows_of({watched, contestant("b", {0, 0.05})}, baseline);
}

TEST(Evaluate, ADisturbedRoundOpensAnEndAndLeavesTheMedianAmongTheGoodOnes) {
    const auto rows = rows_with_disturbed_rounds(1, "b");
    const Row& row = rows[0];
    EXPECT_NEAR(row.ms_per_spp.median, 102, 1e-9); // of -, 101, 102, 103, 104
    EXPECT_EQ(row.ms_per_spp.low, -INFINITY);
    EXPECT_NEAR(row.ms_per_spp.high, 104, 1e-9);
    ASSERT_TRUE(row.efficiency.is_known() && row.seconds_to_target.is_known());
    EXPECT_NEAR(row.efficiency.median * row.mse.median * 64 * 0.1025, 1, 0.1);
    EXPECT_EQ(row.efficiency.high, INFINITY);
    EXPECT_GT(row.efficiency.low, 0);
    ASSERT_TRUE(row.speed_ratio && row.efficiency_ratio);
    EXPECT_NEAR(row.speed_ratio->median, 50 / 102.0, 1e-9);
    EXPECT_EQ(row.speed_ratio->high, INFINITY);
    EXPECT_THAT(row.remarks, ElementsAre(HasSubstr("in 1 of 5 rounds: they were disturbed")));
    EXPECT_THAT(rows[1].remarks, IsEmpty());
    // If the disturbed contestant is the baseline, the ratio is open at the other end. Its ratio to
    // itself does not depend on the round.
    const auto over_it = rows_with_disturbed_rounds(1, "a");
    EXPECT_EQ(over_it[1].speed_ratio->low, -INFINITY);
    EXPECT_NEAR(over_it[1].speed_ratio->median, 102 / 50.0, 1e-9);
    EXPECT_EQ(over_it[0].speed_ratio->median, 1);
}

TEST(Evaluate, MoreThanHalfOfTheRoundsDisturbedLeaveNothingKnown) {
    EXPECT_TRUE(rows_with_disturbed_rounds(2, "b")[0].efficiency.is_known());
    const auto rows = rows_with_disturbed_rounds(3, "b");
    EXPECT_FALSE(rows[0].ms_per_spp.is_known());
    EXPECT_FALSE(rows[0].efficiency.is_known() || rows[0].seconds_to_target.is_known());
    EXPECT_FALSE(rows[0].speed_ratio || rows[0].efficiency_ratio);
    EXPECT_THAT(rows[0].remarks, ElementsAre(HasSubstr("in 3 of 5 rounds: it is too short")));
}

TEST(Evaluate, SaysWhenTimeIsTooShortToMeasure) {
    const auto rows = rows_of({contestant("instant", {1, 0})}, "instant");
    EXPECT_FALSE(rows[0].efficiency.is_known());
    EXPECT_THAT(rows[0].remarks, ElementsAre(HasSubstr("too short to be measured")));
}

} // namespace
} // namespace raylab::bench
