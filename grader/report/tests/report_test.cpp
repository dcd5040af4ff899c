// The report: self-contained, safe against what it shows, true to the data.
#include "grader/report/report.h"

#include "common/cli/files.h"
#include "common/cli/tests/temporary_folder.h"
#include "common/image/image_file.h"
#include "grader/judge/tests/simulated.h"
#include "grader/report/html.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <regex>

namespace raylab {
namespace {
namespace fs = std::filesystem;
using simulated::Noise;
using testing::HasSubstr;
using testing::Not;

Report some_report() {
    const Image reference = simulated::reference(64, 48, 9, Noise::pixel, 16);
    ReportEntry good;
    good.scene = "cornell";
    good.title = "Cornell box";
    good.reason = "Published geometry; colour bleeding.";
    good.lab = "01_recursive";
    good.passed = true;
    good.verdict = {true, "Agrees with the reference.", {}};
    good.checks = {{true, "Mean radiance 0.500 is the closed form's 0.5.", {}}};
    good.seconds = 2.5;
    good.facts = {{"samples a pixel", "256"}};
    good.image = mean_of(simulated::replicates(64, 48, 1, 16, Noise::pixel));
    good.reference = reference;
    good.verdict.measured = {measure(*good.image, reference), z_map(*good.image, reference)};
    good.lanes_alive = {0.97, 0.8, 0.58};
    good.details = {{"p", 0.3}};
    ReportEntry bad = good;
    bad.lab = "02_iterative";
    bad.passed = false;
    bad.verdict = {false, "The image is too dark by 20 %.", {"Is a technique missing?"}};
    for (Vec3& v : bad.image->mean) v *= 0.8f;
    bad.verdict.measured = {measure(*bad.image, reference), z_map(*bad.image, reference)};
    return {"raylab demo", "Some CPU, 2 cores", "./raylab demo", {good, bad}};
}

TEST(Html, TextCannotBecomeMarkup) {
    EXPECT_EQ(escape_html("<b a=\"1\" b='2'>&"), "&lt;b a=&quot;1&quot; b=&#39;2&#39;&gt;&amp;");
    EXPECT_EQ(escape_script_json("\"</script><!--\""), "\"\\u003c/script>\\u003c!--\"");
}

TEST(Report, HostileTextStaysText) {
    Report report = some_report();
    const std::string attack = "</script><script>alert(1)</script><img src=x onerror=alert(1)>\"'";
    report.title = report.machine = report.command = attack;
    for (ReportEntry& e : report.entries) {
        e.scene = e.title = e.reason = e.lab = attack;
        e.verdict.sentence = attack;
        e.verdict.hints = {attack};
        e.checks = {{false, attack, {}}};
        e.facts = {{attack, attack}};
    }
    const std::string html = report_html(report);
    EXPECT_THAT(html, Not(HasSubstr("<img")));
    EXPECT_THAT(html, Not(HasSubstr("alert(1)<")));
    const std::regex script("<script");
    EXPECT_EQ(std::distance(std::sregex_iterator(html.begin(), html.end(), script),
                            std::sregex_iterator()),
              2)
        << "the data and the page's own";
}

TEST(Report, NothingIsFetchedFromAnywhere) {
    const std::string html = report_html(some_report());
    EXPECT_THAT(html, HasSubstr("default-src 'none'"));
    EXPECT_THAT(html, Not(HasSubstr("http://")));
    EXPECT_THAT(html, Not(HasSubstr("https://")));
    EXPECT_THAT(html, Not(HasSubstr("unsafe-inline")));
    EXPECT_THAT(html, Not(HasSubstr(" style=")));
}

TEST(Report, CaptionsAreComputedFromTheData) {
    Report report = some_report();
    EXPECT_THAT(report_html(report), HasSubstr("<strong>1 of 2</strong> passed"));
    EXPECT_THAT(report_html(report),
                HasSubstr("Lanes alive fall from 97.0 % at the first bounce to "
                          "58.0 % at bounce 3."));
    EXPECT_THAT(report_html(report), HasSubstr("The mean differs by -20 %"));
    report.entries[0].lanes_alive = {0.5, 0.6};
    EXPECT_THAT(report_html(report), HasSubstr("Lanes alive rise from 50.0 %"));
}

// The figures are those that the judge measured, even if the pictures would give others.
TEST(Report, MeasuresNothingItself) {
    Report report = some_report();
    report.entries.resize(1);
    Measures& judged = *report.entries[0].verdict.measured;
    judged.metrics.rel_error = 0.4321;
    judged.metrics.rel_mse = 0.0625;
    judged.z_map.z.assign(judged.z_map.z.size(), 3.25);
    const std::string html = report_html(report);
    EXPECT_THAT(html, HasSubstr("+43.21&#8239;%"));
    EXPECT_THAT(html, HasSubstr("6.2e-02"));
    EXPECT_THAT(html, HasSubstr("The mean differs by +43 %"));
    EXPECT_THAT(html, HasSubstr("the largest is +3.2"));
    EXPECT_THAT(html, HasSubstr("\"z\":[3.25,3.25"));
    EXPECT_EQ(report_json(report)["entries"][0]["metrics"]["relative_error_of_mean"], 0.4321);
}

TEST(Report, AReferenceOfTwoEntriesIsStoredOnce) {
    Report report = some_report();
    const std::string picture = radiance_png(*report.entries[0].reference);
    const std::string html = report_html(report);
    const std::size_t at = html.find(picture);
    ASSERT_NE(at, std::string::npos);
    EXPECT_EQ(html.find(picture, at + 1), std::string::npos);
}

TEST(Report, EntriesWithoutPicturesOrOfOtherSizesAreShownAsFarAsTheyGo) {
    Report report = some_report();
    report.entries[0].image.reset();
    report.entries[1].reference = simulated::reference(10, 10, 1, Noise::pixel, 16);
    const std::string html = report_html(report);
    EXPECT_THAT(html, HasSubstr("data-mode=\"rendered\""));
    EXPECT_THAT(html, Not(HasSubstr("data-mode=\"slider\"")));
    EXPECT_TRUE(report_json(report)["entries"][1]["metrics"].is_null());
    report.entries.clear();
    EXPECT_THAT(report_html(report), HasSubstr("<strong>0 of 0</strong>"));
}

// What page.js does, on the picture's own bytes.
TEST(Report, WhatCannotBeDecidedIsNotCalledFailed) {
    Report report = some_report();
    report.entries.resize(1);
    report.entries[0].passed = report.entries[0].decided = false;
    const std::string page = report_html(report);
    EXPECT_THAT(page, HasSubstr(">undecided</span>"));
    EXPECT_THAT(page, Not(HasSubstr(">failed</span>")));
    EXPECT_EQ(report_json(report)["entries"][0]["decided"], false);
}

TEST(Report, PicturesKeepTheRangeOfRadiance) {
    Image image = simulated::render(4, 1, 1, 1, Noise::pixel);
    image.mean = {Vec3(1e-6f, 2e-6f, 1e-7f), Vec3(3e5f, 1e5f, 0), Vec3(0), Vec3(NAN)};
    const std::string url = radiance_png(image);
    ASSERT_TRUE(url.starts_with("data:image/png;base64,iVBORw0KGgo"));

    const TemporaryFolder folder;
    const fs::path file = folder / "picture.png";
    const std::string text = url.substr(url.find(',') + 1);
    std::string bytes;
    unsigned bits = 0;
    int count = 0;
    for (const char c : text) {
        if (c == '=') break;
        const int digit = c >= 'A' && c <= 'Z'   ? c - 'A'
                          : c >= 'a' && c <= 'z' ? c - 'a' + 26
                          : c >= '0' && c <= '9' ? c - '0' + 52
                                                 : (c == '+' ? 62 : 63);
        bits = bits << 6 | unsigned(digit);
        count += 6;
        if (count >= 8) bytes += static_cast<char>(bits >> (count -= 8) & 255);
    }
    write_file(file.string(), bytes);
    const Image png = read_image(file.string()); // linear: back to bytes by the sRGB curve
    const auto byte = [&](int x, int c) {
        const float v = png.mean[std::size_t(x)][c];
        return std::lround(
            255 * (v <= 0.0031308f ? 12.92f * v : 1.055f * std::pow(v, 1 / 2.4f) - 0.055f));
    };
    for (int x = 0; x < 2; ++x)
        for (int c = 0; c < 3; ++c) {
            const double value =
                (double(byte(x, c)) + 0.5) * std::exp2(double(byte(x + 4, c)) - 136);
            EXPECT_NEAR(value, image.mean[std::size_t(x)][c],
                        max_component(image.mean[std::size_t(x)]) / 250)
                << x << c;
        }
    EXPECT_LE(byte(2 + 4, 0), 1) << "black";
    EXPECT_EQ(byte(3 + 4, 0), 255) << "not a number";
}

TEST(Report, BothFilesAreWrittenAndResultsHoldTheFacts) {
    const TemporaryFolder folder;
    const std::string name = folder.path();
    Report report = some_report();
    report.entries[0].verdict.sentence = "not UTF-8: \xff";
    write_report(report, name + "/deep/er");
    const auto json = nlohmann::json::parse(read_file(name + "/deep/er/results.json"));
    EXPECT_EQ(json["passed"], false);
    EXPECT_EQ(json["entries"].size(), 2u);
    EXPECT_EQ(json["entries"][1]["verdict"]["sentence"], "The image is too dark by 20 %.");
    EXPECT_NEAR(json["entries"][1]["metrics"]["relative_error_of_mean"].get<double>(), -0.2, 0.01);
    EXPECT_EQ(json["entries"][0]["lanes_share"][2], 0.58);
    EXPECT_TRUE(fs::exists(name + "/deep/er/report.html"));
    // For looking at: RAYLAB_KEEP_REPORT=FOLDER.
    if (const char* keep = std::getenv("RAYLAB_KEEP_REPORT")) write_report(some_report(), keep);
}

} // namespace
} // namespace raylab
