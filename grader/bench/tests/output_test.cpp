// bench.csv, bench.json and bench.html of a bench in which everything happens.
#include "grader/bench/bench.h"
#include "grader/bench/page.h"
#include "grader/bench/tests/csv.h"
#include "grader/bench/tests/simulated_contestant.h"

#include <gmock/gmock.h>

namespace raylab::bench {
namespace {

using simulated_bench::contestant;
using testing::HasSubstr;
using testing::Not;

Bench everything() {
    Bench bench;
    bench.machine = {"2026-01-01 00:00", "a <cpu>", 2, 0.5, "g++", "-O3", "abc", false};
    bench.options.baseline = "right";
    bench.options.plan.spp = {16, 64};
    bench.threads = 2;
    const Contestant broken = {"broken", "", [](int, std::uint32_t) -> Drawn {
                                   throw ContestantError("failed, with a \"quote\", and\na line");
                               }};
    SceneResult scene{"room", "A <b>room</b>", "0123", 48, 48, 8, "Errors come from pairs.", {}};
    scene.rows = simulated_bench::rows_of(
        {contestant("right", {}), contestant("dark", {1, 0.1, 0.9f}), broken}, "right");
    bench.scenes = {scene};
    bench.notes = {"cycles: not here."};
    return bench;
}

TEST(Csv, EveryLineHasTheHeadersFields) {
    const auto lines = parse_csv(to_csv(everything()));
    ASSERT_EQ(lines.size(), 4u);
    for (const auto& line : lines) EXPECT_EQ(line.size(), lines[0].size()) << line[3];
    const auto column = [&](const std::string& name) {
        return std::find(lines[0].begin(), lines[0].end(), name) - lines[0].begin();
    };
    EXPECT_EQ(lines[1][column("efficiency_ratio")], "1");
    EXPECT_EQ(lines[1][column("ms_per_spp")], "100");
    EXPECT_EQ(lines[2][column("efficiency_ratio")], "");
    EXPECT_EQ(lines[2][column("agrees")], "no");
    EXPECT_EQ(lines[3][column("verdict")], "failed, with a \"quote\", and\na line");
}

TEST(Json, HoldsRoundsAndNoRatioOfAWrongImage) {
    const auto json = to_json(everything());
    const auto& rows = json["scenes"][0]["rows"];
    EXPECT_EQ(rows[0]["ms_per_spp"]["rounds"].size(), 5u);
    EXPECT_TRUE(rows[0]["bias"]["relative"].is_null());
    EXPECT_FALSE(rows[0]["efficiency_ratio"].is_null());
    EXPECT_TRUE(rows[1]["efficiency_ratio"].is_null() && rows[1]["speed_ratio"].is_null());
    EXPECT_THAT(rows[2]["failure"].get<std::string>(), HasSubstr("failed"));
    EXPECT_EQ(json["machine"]["commit"], "abc");
    EXPECT_EQ(nlohmann::ordered_json::parse(json.dump()), json);
}

TEST(Table, SaysThatImagesDiffer) {
    const std::string table = to_table(everything().scenes[0]);
    EXPECT_THAT(table, HasSubstr("images differ: "));
    EXPECT_THAT(table, HasSubstr("failed, with a"));
}

TEST(OpenEnds, AreSaidAsSuch) {
    Bench bench = everything();
    Row& row = bench.scenes[0].rows[0];
    row.efficiency = measured({1, 2, 3, 4, INFINITY});
    EXPECT_THAT(to_table(bench.scenes[0]), HasSubstr("3 [1, open]"));
    EXPECT_THAT(page_html(to_json(bench), ""), HasSubstr("1.00 &ndash; open"));
    EXPECT_TRUE(to_json(bench)["scenes"][0]["rows"][0]["efficiency"]["high"].is_null());
}

TEST(Page, EscapesWhatItShowsAndReachesForNothing) {
    const std::string page = page_html(to_json(everything()), "a <cpu>");
    EXPECT_THAT(page, HasSubstr("A &lt;b&gt;room&lt;/b&gt;"));
    EXPECT_THAT(page, Not(HasSubstr("<b>room")));
    EXPECT_THAT(page, HasSubstr("a &lt;cpu&gt;"));
    EXPECT_THAT(page, HasSubstr("default-src 'none'"));
    EXPECT_THAT(page, HasSubstr("images differ"));
    EXPECT_THAT(page, Not(testing::ContainsRegex("(src|href)=\"http")));
}

} // namespace
} // namespace raylab::bench
