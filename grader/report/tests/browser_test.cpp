// The page in a real browser, if there is one: the script runs under the page's own security
// policy, and the address alone brings back a view.
#include "grader/judge/tests/simulated.h"
#include "grader/report/report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>

namespace raylab {
namespace {
using simulated::Noise;
using testing::HasSubstr;
using testing::Not;

std::string output_of(const std::string& command) {
    std::string text;
    if (FILE* pipe = popen(command.c_str(), "r")) {
        char block[4096];
        while (const std::size_t n = std::fread(block, 1, sizeof block, pipe))
            text.append(block, n);
        pclose(pipe);
    }
    return text;
}

TEST(Browser, TheAddressBringsBackAView) {
    std::string browser = output_of("command -v chromium || command -v chromium-browser || "
                                    "command -v google-chrome");
    if (browser.empty()) GTEST_SKIP() << "no Chromium is installed";
    browser.pop_back(); // the end of line

    std::string folder =
        (std::filesystem::temp_directory_path() / "raylab-browser-XXXXXX").string();
    ASSERT_NE(mkdtemp(folder.data()), nullptr);
    ReportEntry entry;
    entry.scene = "cornell";
    entry.lab = "02_iterative";
    entry.image = mean_of(simulated::replicates(40, 40, 1, 16, Noise::pixel));
    entry.reference = simulated::reference(40, 40, 9, Noise::pixel, 16);
    write_report({"test", "", "", {entry}}, folder);
    const auto page_at = [&](const std::string& view) {
        return output_of("timeout 60 '" + browser +
                         "' --headless=new --no-sandbox --disable-gpu --user-data-dir='" + folder +
                         "/profile' --virtual-time-budget=5000 --dump-dom 'file://" + folder +
                         "/report.html#at=cornell-02_iterative&" + view + "' 2>/dev/null");
    };
    const std::string page = page_at("mode=z&ev=-1.5");
    std::filesystem::remove_all(folder);
    if (page.empty()) GTEST_SKIP() << "Chromium does not start here";
    EXPECT_THAT(page, HasSubstr("data-ready=\"true\"")) << "the script did not run to its end";
    EXPECT_THAT(page, HasSubstr("data-mode=\"z\" aria-pressed=\"true\""));
    EXPECT_THAT(page, HasSubstr("<figcaption>Each 16 x 16 tile's mean"));
    EXPECT_THAT(page, HasSubstr("<output>-1.5 stops</output>"));
}

} // namespace
} // namespace raylab
