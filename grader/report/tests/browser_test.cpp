// The page in a real browser, if there is one: the script runs under the page's own security
// policy, and the address alone brings back a view.
#include "common/cli/tests/temporary_folder.h"
#include "grader/judge/tests/simulated.h"
#include "grader/report/report.h"
#include "grader/report/tests/browser.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace raylab {
namespace {
using simulated::Noise;
using testing::HasSubstr;

TEST(Browser, TheAddressBringsBackAView) {
    const TemporaryFolder temporary;
    const std::string folder = temporary.path();
    ReportEntry entry;
    entry.scene = "cornell";
    entry.lab = "02_iterative";
    entry.image = mean_of(simulated::replicates(40, 40, 1, 16, Noise::pixel));
    entry.reference = simulated::reference(40, 40, 9, Noise::pixel, 16);
    entry.verdict.measured = {{}, z_map(*entry.image, *entry.reference)};
    write_report({"test", "", "", {entry}}, folder);
    const std::string page =
        page_in_browser(folder + "/report.html#at=cornell-02_iterative&mode=z&ev=-1.5", folder);
    if (page.empty()) GTEST_SKIP() << "no Chromium, or it does not start";
    EXPECT_THAT(page, HasSubstr("data-ready=\"true\"")) << "the script did not run to its end";
    EXPECT_THAT(page, HasSubstr("data-mode=\"z\" aria-pressed=\"true\""));
    EXPECT_THAT(page, HasSubstr("<figcaption>Each 16 x 16 tile's mean"));
    EXPECT_THAT(page, HasSubstr("<output>-1.5 stops</output>"));
}

} // namespace
} // namespace raylab
