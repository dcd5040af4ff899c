// The rare cases as they are written: the page's section, the CSV, and a tree without a megakernel.
#include "grader/bench/bench.h"
#include "grader/bench/page.h"
#include "grader/bench/tests/csv.h"
#include "grader/report/tests/browser.h"

#include <gmock/gmock.h>

#include <filesystem>

namespace raylab::bench {
namespace {

using testing::HasSubstr;
using testing::Not;

RareCaseRow row(std::optional<double> megakernel) {
    return {"a <b>tiny</b>, \"small\" image",
            "tiny & small",
            "fits <i>at once</i>",
            32,
            24,
            megakernel,
            {.seconds = 0.004, .iterations = 8, .launches = 40, .rays = 2000, .blocks = 96},
            {.seconds = 0.003, .iterations = 8, .launches = 56, .rays = 2000, .blocks = 24}};
}

Bench bench_of(std::vector<RareCaseRow> rows) {
    Bench bench;
    bench.options.baseline = "03";
    bench.options.plan.spp = {4, 16};
    bench.rare_cases = std::move(rows);
    return bench;
}

std::string page_of(std::vector<RareCaseRow> rows) {
    return page_html(to_json(bench_of(std::move(rows))), "a machine");
}

TEST(RareCases, HaveASectionOnThePageOnlyWhenTheyWereMeasured) {
    const std::string page = page_of({row(0.002)});
    EXPECT_THAT(page, HasSubstr("<section id=\"rare-cases\">"));
    EXPECT_THAT(page, HasSubstr("data-plot=\"rare_cases\" data-quantity=\"seconds\""));
    EXPECT_THAT(page, HasSubstr("data-plot=\"rare_cases\" data-quantity=\"blocks\""));
    EXPECT_THAT(page, HasSubstr("&times;&#8239;2.00")) << "4 ms without, of the megakernel's 2 ms";
    EXPECT_THAT(page, HasSubstr("&times;&#8239;1.50")) << "3 ms with compaction";
    EXPECT_THAT(page, HasSubstr("<td class=\"number\">250</td>")) << "2000 rays in 8 iterations";
    EXPECT_THAT(page_of({}), Not(HasSubstr("rare-cases")));
}

TEST(RareCases, EscapeTheirNames) {
    const std::string page = page_of({row(0.002)});
    EXPECT_THAT(page, HasSubstr("a &lt;b&gt;tiny&lt;/b&gt;, &quot;small&quot; image"));
    EXPECT_THAT(page, HasSubstr("tiny &amp; small"));
    EXPECT_THAT(page, HasSubstr("fits &lt;i&gt;at once&lt;/i&gt;"));
    // Neither in the table nor in the data that the plots read.
    EXPECT_THAT(page, Not(HasSubstr("<b>tiny")));
    EXPECT_THAT(page, Not(HasSubstr("<i>at once")));
}

// In a real browser, if there is one: the plots' script runs to its end under the page's policy.
TEST(RareCases, AreDrawnInABrowser) {
    const std::string folder = testing::TempDir() + "raylab-rare-cases-page";
    for (const bool with_megakernel : {true, false}) {
        std::filesystem::create_directories(folder);
        write_bench(bench_of({row(with_megakernel ? std::optional(0.002) : std::nullopt)}), folder);
        const std::string page = page_in_browser(folder + "/bench.html", folder);
        std::filesystem::remove_all(folder);
        if (page.empty()) GTEST_SKIP() << "no Chromium, or it does not start";
        EXPECT_THAT(page, HasSubstr("data-ready=\"true\"")) << "the script did not run to its end";
        EXPECT_THAT(page, HasSubstr("small\" image, with compaction: 24 blocks"));
        EXPECT_THAT(page, HasSubstr(with_megakernel ? ">1.50</text>" : ">0.75</text>"))
            << "3 ms over the megakernel's 2, or over the 4 without compaction";
    }
}

TEST(RareCases, HaveTwoLinesEachInTheCsv) {
    const auto lines = parse_csv(to_csv(std::vector{row(0.002), row({})}));
    ASSERT_EQ(lines.size(), 5u);
    for (const auto& line : lines) EXPECT_EQ(line.size(), lines[0].size());
    const auto column = [&](const std::string& name) {
        return std::find(lines[0].begin(), lines[0].end(), name) - lines[0].begin();
    };
    EXPECT_EQ(lines[1][column("case")], "a <b>tiny</b>, \"small\" image");
    EXPECT_EQ(lines[1][column("compaction")], "no");
    EXPECT_EQ(lines[1][column("blocks")], "96");
    EXPECT_EQ(lines[2][column("compaction")], "yes");
    EXPECT_EQ(lines[2][column("blocks")], "24");
    EXPECT_EQ(lines[2][column("live_rays")], "250");
    EXPECT_EQ(lines[2][column("megakernel_seconds")], "0.002");
    EXPECT_EQ(lines[2][column("batches")], "") << "not counted";
    EXPECT_EQ(lines[3][column("megakernel_seconds")], "") << "a tree without lab 02";
}

} // namespace
} // namespace raylab::bench
