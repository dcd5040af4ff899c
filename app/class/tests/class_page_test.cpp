// class.html in a real browser: its script runs under the page's own policy; filter and order work.
#include "app/class/tests/class_in_folder.h"
#include "grader/report/tests/browser.h"

#include <gmock/gmock.h>

namespace raylab {
namespace {

using testing::HasSubstr;

TEST(ClassPage, CountsWhatPassedAndNamesTheCommonestCause) {
    ClassInFolder all;
    for (const char* name : {"a1", "a2", "a3"}) all.student(name, "half");
    all.student("b", "right");
    all.run_all();
    const std::string page = all.text("out/class.html");
    EXPECT_THAT(page, HasSubstr("<td class=\"number\">1 of 4</td>"));
    // The causes differ in a number alone, "a factor a1 of pi", "a factor a2 of pi"; the first is
    // shown.
    EXPECT_THAT(page, HasSubstr("a factor a1 of pi (3 of 3)"));
    EXPECT_THAT(page, HasSubstr("3 WRONG_IMAGE"));
    EXPECT_THAT(page, HasSubstr("the median is 60"));
}

TEST(ClassPage, FiltersByItsAddress) {
    ClassInFolder all;
    all.student("ada", "half");
    all.student("ben", "right");
    all.run_all();
    const std::string file = (all / "out/class.html").string(), folder = (all / "browser").string();
    const std::string page = page_in_browser(file + "#verdict=PASS", folder);
    ASSERT_NE(page, "") << "no Chromium, or it does not start";
    EXPECT_THAT(page, HasSubstr("data-ready=\"true\""));
    EXPECT_THAT(page, HasSubstr("1 of 2</output>"));
    EXPECT_THAT(page, HasSubstr("<tr data-verdict=\"WRONG_IMAGE\" hidden=\"\">"));
}

} // namespace
} // namespace raylab
