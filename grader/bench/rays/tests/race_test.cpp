// Turns, ratios, and that a contestant with wrong answers gets no ratio.
#include "grader/bench/rays/race.h"

#include "grader/bench/rays/rays_bench.h"
#include "grader/bench/rays/tests/fake_contestant.h"

#include <gmock/gmock.h>

namespace raylab::bench {
namespace {

using testing::HasSubstr;

RaceOptions against(const std::string& baseline) {
    RaceOptions options;
    options.baseline = baseline;
    options.builds = 1;
    options.least_seconds = 0; // one run a round
    return options;
}

TEST(Race, RatiosAreThoseOfTheTimes) {
    const RayRace result =
        race(small_mesh(), {fake("slow", {200}), fake("fast", {50})}, against("slow"));
    ASSERT_EQ(result.rows.size(), 2u);
    for (const RayCell& cell : result.rows[1].cells) {
        ASSERT_TRUE(cell.ratio);
        EXPECT_NEAR(cell.ratio->median, 4, 1e-12);
        EXPECT_NEAR(cell.ratio->low, cell.ratio->high, 1e-12);
        EXPECT_NEAR(cell.mrays.median, 20, 1e-9);
    }
    EXPECT_EQ(result.rows[1].build_seconds.median, 0.25);
    EXPECT_EQ(result.rows[1].bytes_per_triangle, 10);
    EXPECT_EQ(result.truth, "slow");
}

TEST(Race, WhoBeginsMovesOn) {
    std::vector<std::string> log;
    Fake logged;
    logged.log = &log;
    RaceOptions options = against("a");
    options.kinds = {RayKind::ao};
    race(small_mesh(), {fake("a", logged), fake("b", logged), fake("c", logged)}, options);
    // The last fifteen calls are the rounds. The calls before them fetch answers and make rays.
    const std::vector<std::string> rounds(log.end() - 15, log.end());
    EXPECT_THAT(rounds, testing::ElementsAre("a", "b", "c", "b", "c", "a", "c", "a", "b", "a", "b",
                                             "c", "b", "c", "a"));
}

// The cell of primary rays of a contestant whose answers are spoiled.
RayCell spoiled(bool is_exact, const std::function<void(RayAnswer&)>& spoil, int every) {
    const auto all = [spoil, every](std::span<RayAnswer> answers) {
        for (std::size_t i = 0; i < answers.size(); i += std::size_t(every)) spoil(answers[i]);
    };
    return race(small_mesh("terrain"), {fake("right"), fake("spoiled", {100, is_exact, all})},
                against("right"))
        .rows[1]
        .cells[0];
}

TEST(Race, AWrongAnswerIsCountedAndCostsTheRatio) {
    const auto miss = [](RayAnswer& a) { a = {}; };
    const auto invent = [](RayAnswer& a) { a = {1, 0}; };
    for (const bool is_exact : {true, false}) {
        EXPECT_FALSE(spoiled(is_exact, miss, 1).agrees);
        EXPECT_FALSE(spoiled(is_exact, miss, 1).ratio);
        EXPECT_FALSE(spoiled(is_exact, invent, 1).ratio);
        EXPECT_TRUE(spoiled(
                        is_exact, [](RayAnswer&) {}, 1)
                        .ratio);
    }
}

TEST(Race, BitsAreAskedOfTheExactAToleranceIsLeftToOthers) {
    const auto off = [](float share) { return [share](RayAnswer& a) { a.t *= 1 + share; }; };
    EXPECT_FALSE(spoiled(true, off(1e-6f), 1).agrees);
    EXPECT_TRUE(spoiled(false, off(1e-6f), 1).agrees);
    EXPECT_FALSE(spoiled(false, off(1e-3f), 1).agrees);
    const auto other_triangle = [](RayAnswer& a) { a.triangle += a.triangle >= 0; };
    EXPECT_FALSE(spoiled(true, other_triangle, 1).agrees) << "a tie goes to the lowest";
    EXPECT_TRUE(spoiled(false, other_triangle, 1).agrees);
}

TEST(Race, WhoCannotTakePartIsARowThatSaysWhy) {
    RayContestant slow = brute_force();
    slow.most_tests = 1000;
    const RayRace result =
        race(small_mesh(), {broken("broken"), slow, fake("right")}, against("x"));
    EXPECT_THAT(result.rows[0].failure, HasSubstr("no memory"));
    EXPECT_THAT(result.rows[1].failure, HasSubstr("16 x 16 rays are too many tests"));
    EXPECT_EQ(result.truth, "right");
    EXPECT_FALSE(result.rows[2].cells[0].ratio) << "the baseline takes no part";
    EXPECT_THROW(race(small_mesh(), {broken("broken")}, against("x")), ContestantError);
}

TEST(Race, BruteForceVerifiesSomeWhenNobodyElseCan) {
    // All contestants are wrong in the same way, so they agree with each other.
    const auto miss = [](std::span<RayAnswer> answers) {
        for (RayAnswer& a : answers) a = {};
    };
    RaceOptions options = against("a");
    options.verify = 100;
    const auto cell = [&] {
        return race(small_mesh("terrain"),
                    {fake("a", {100, true, miss}), fake("b", {50, true, miss})}, options)
            .rows[1]
            .cells[0];
    };
    EXPECT_EQ(cell().differing, 0);
    EXPECT_EQ(cell().verified, 100);
    EXPECT_GT(cell().wrong, 0);
    EXPECT_FALSE(cell().ratio);
    options.verify = 0;
    EXPECT_EQ(cell().verified, 0);
    EXPECT_TRUE(cell().ratio);
}

TEST(Race, AShortRunIsRepeatedUntilItCanBeTimed) {
    std::vector<std::string> log;
    Fake logged;
    logged.log = &log;
    RaceOptions options = against("a");
    options.kinds = {RayKind::primary};
    options.least_seconds = 1e-4; // 256 rays at 100 ns are 25.6 us: four times
    const RayRace result = race(small_mesh(), {fake("a", logged)}, options);
    // Two calls make the rays, one gives the truth's answers, and one gives the contestant's own.
    EXPECT_EQ(log.size(), 4u + 5 * 4);
    EXPECT_NEAR(result.rows[0].cells[0].mrays.median, 10, 1e-9);
}

TEST(Race, TruthIsTheFirstExactOne) {
    const RayRace result =
        race(small_mesh(), {fake("peer", {100, false}), fake("a"), fake("b")}, against("peer"));
    EXPECT_EQ(result.truth, "a");
}

TEST(Summary, IsTheGeometricMeanOrSaysWhatIsMissing) {
    RaysBench bench;
    bench.options = against("base");
    // Twice as fast on one mesh and half as fast on the other, so the mean ratio is 1.
    bench.races = {race(small_mesh("terrain"), {fake("base"), fake("other", {50})}, bench.options),
                   race(small_mesh(), {fake("base"), fake("other", {200})}, bench.options)};
    std::vector<RaySummary> all = summaries(bench);
    ASSERT_TRUE(all[1].mean);
    EXPECT_NEAR(all[1].mean->median, 1, 1e-12);
    EXPECT_NEAR(all[1].worst, 0.5, 1e-12);
    EXPECT_NEAR(all[1].best, 2, 1e-12);
    bench.races[1].rows[1].cells[3].ratio.reset();
    all = summaries(bench);
    EXPECT_FALSE(all[1].mean);
    EXPECT_EQ(all[1].why_not, "9 of 10 ratios");
}

} // namespace
} // namespace raylab::bench
