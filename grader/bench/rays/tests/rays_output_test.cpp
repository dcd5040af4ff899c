// rays.csv, rays.json and rays.html of a bench in which everything happens.
#include "grader/bench/rays/rays_bench.h"
#include "grader/bench/rays/tests/fake_contestant.h"
#include "grader/bench/tests/csv.h"
#include "grader/report/tests/browser.h"

#include <gmock/gmock.h>

#include <filesystem>

namespace raylab::bench {
namespace {

using testing::HasSubstr;
using testing::Not;

RaysBench everything() {
    RaysBench bench;
    bench.machine = {"2026-01-01 00:00", "a <cpu>", 2, 0.5, "g++", "-O3", "abc", false};
    bench.options.baseline = "right";
    bench.options.least_seconds = 0;
    bench.width = bench.height = 16;
    bench.scaling = "terrain";
    bench.notes = {"embree: not <here>."};
    const auto miss = [](std::span<RayAnswer> answers) {
        for (RayAnswer& a : answers) a = {};
    };
    bench.races = {race(small_mesh("terrain"),
                        {fake("right"), fake("wrong", {50, true, miss}), broken("broken")},
                        bench.options)};
    return bench;
}

TEST(RaysCsv, EveryLineHasTheHeadersFields) {
    const auto lines = parse_csv(to_csv(everything()));
    ASSERT_EQ(lines.size(), 1u + 5 + 5 + 1);
    for (const auto& line : lines) EXPECT_EQ(line.size(), lines[0].size()) << line[2];
    const auto column = [&](const std::string& name) {
        return std::size_t(std::find(lines[0].begin(), lines[0].end(), name) - lines[0].begin());
    };
    EXPECT_EQ(lines[1][column("rays")], "primary");
    EXPECT_EQ(lines[1][column("ratio")], "1");
    EXPECT_EQ(lines[1][column("mrays_per_second")], "10");
    EXPECT_EQ(lines[6][column("ratio")], "");
    EXPECT_EQ(lines[6][column("agrees")], "no");
    EXPECT_EQ(lines[11][column("failure")], "no memory, and a \"quote\"");
}

TEST(RaysJson, HoldsRoundsAndNoRatioOfWrongAnswers) {
    const auto json = to_json(everything());
    const auto& rows = json["races"][0]["rows"];
    EXPECT_EQ(rows[0]["cells"][0]["mrays_per_second"]["rounds"].size(), 5u);
    EXPECT_FALSE(rows[0]["cells"][0]["ratio"].is_null());
    EXPECT_TRUE(rows[1]["cells"][0]["ratio"].is_null());
    EXPECT_FALSE(rows[1]["cells"][0]["agrees"]);
    EXPECT_TRUE(rows[0]["cells"][0]["nodes_per_ray"].is_null()) << "not counted";
    EXPECT_THAT(rows[2]["failure"].get<std::string>(), HasSubstr("no memory"));
    EXPECT_TRUE(json["summaries"][1]["mean"].is_null());
    EXPECT_EQ(nlohmann::ordered_json::parse(json.dump()), json);
}

TEST(RaysJson, GivesWhatIsBuiltAColourAndItsWalksLinesOfTheirOwn) {
    RaysBench bench = everything();
    bench.races = {race(small_mesh("terrain"),
                        {fake("embree"), fake("kd_stack"), fake("sah_trail"), fake("kd_ropes")},
                        bench.options)};
    const auto styles = to_json(bench)["styles"];
    EXPECT_EQ(styles["kd_stack"]["colour"], styles["kd_ropes"]["colour"]);
    EXPECT_EQ(styles["kd_stack"]["walk"], 0);
    EXPECT_EQ(styles["kd_ropes"]["walk"], 1);
    EXPECT_EQ(styles["kd_ropes"]["built"], "kd");
    EXPECT_EQ(styles["sah_trail"]["walk"], 0);
    EXPECT_NE(styles["sah_trail"]["colour"], styles["kd_stack"]["colour"]);
    EXPECT_NE(styles["embree"]["colour"], styles["kd_stack"]["colour"]);
}

TEST(RaysTable, SaysWhoGetsNoRatioAndWhy) {
    const RaysBench bench = everything();
    const std::string table = to_table(bench.races[0], "right");
    EXPECT_THAT(table, HasSubstr("no ratio"));
    EXPECT_THAT(table, HasSubstr("no memory"));
    EXPECT_THAT(to_table(summaries(bench), "right"), HasSubstr("2 of 5 ratios"));
}

TEST(RaysPage, EscapesWhatItShowsAndReachesForNothing) {
    const std::string page = rays_page_html(to_json(everything()), "a <cpu>");
    EXPECT_THAT(page, HasSubstr("the &lt;right&gt;, fake"));
    EXPECT_THAT(page, HasSubstr("not &lt;here&gt;"));
    EXPECT_THAT(page, HasSubstr("a &lt;cpu&gt;"));
    EXPECT_THAT(page, HasSubstr("answers differ: no ratio"));
    EXPECT_THAT(page, HasSubstr("data-plot=\"build\""));
    EXPECT_THAT(page, HasSubstr("default-src 'none'"));
    EXPECT_THAT(page, Not(testing::ContainsRegex("(src|href)=\"http")));
}

// In a real browser, if there is one: the plots' script runs to its end under the page's policy.
TEST(RaysPage, DrawsItsPlotsInABrowser) {
    const std::string folder = testing::TempDir() + "raylab-rays-page";
    std::filesystem::create_directories(folder);
    write_rays_bench(everything(), folder);
    const std::string page = page_in_browser(folder + "/rays.html", folder);
    std::filesystem::remove_all(folder);
    if (page.empty()) GTEST_SKIP() << "no Chromium, or it does not start";
    EXPECT_THAT(page, HasSubstr("data-ready=\"true\"")) << "the script did not run to its end";
    EXPECT_THAT(page, HasSubstr("microseconds to build a triangle against triangles"));
    EXPECT_THAT(page, HasSubstr("the &lt;right&gt;, fake, primary: 10 Mrays/s"));
    EXPECT_THAT(page, HasSubstr("primary: 20 Mrays/s, answers differ"));
}

} // namespace
} // namespace raylab::bench
