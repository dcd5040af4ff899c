#include "grader/results/text.h"

#include <gtest/gtest.h>

namespace raylab {
namespace {

TEST(Text, IsValidUtf8WithoutControlCharacters) {
    EXPECT_EQ(clean_utf8("a\tb\r\nc"), "a\tb\nc");
    EXPECT_EQ(clean_utf8("gr\xC3\xBC\xC3\x9F \xE2\x82\xAC \xF0\x9F\x8E\x89"),
              "gr\xC3\xBC\xC3\x9F \xE2\x82\xAC \xF0\x9F\x8E\x89");
    const std::string bad = "\xEF\xBF\xBD";
    EXPECT_EQ(clean_utf8("\x1B[31mred"), bad + "[31mred");
    EXPECT_EQ(clean_utf8(std::string_view("\0", 1)), bad);
    EXPECT_EQ(clean_utf8("\xC3"), bad);                               // cut off
    EXPECT_EQ(clean_utf8("\xC0\x80"), bad + bad);                     // overlong
    EXPECT_EQ(clean_utf8("\xED\xA0\x80"), bad + bad + bad);           // a surrogate
    EXPECT_EQ(clean_utf8("\xF4\x90\x80\x80"), bad + bad + bad + bad); // above U+10FFFF
    EXPECT_EQ(clean_utf8("\xEF\xBF\xBE"), bad);                       // U+FFFE
}

TEST(Text, IsCutBetweenCharacters) {
    EXPECT_EQ(shortened("short", 5), "short");
    std::string euros;
    for (int i = 0; i < 100; ++i) euros += "\xE2\x82\xAC";
    for (std::size_t most = 0; most < 70; ++most) {
        const std::string text = shortened(euros, most);
        EXPECT_LE(text.size(), most);
        EXPECT_EQ(clean_utf8(text), text) << most;
    }
}

TEST(Text, IsOneFieldOfCsvAndNoFormula) {
    EXPECT_EQ(csv_field("a, \"b\"\nc"), "\"a, \"\"b\"\" c\"");
    EXPECT_EQ(csv_field("=1+1"), "\"'=1+1\"");
    EXPECT_EQ(csv_field("\r=1+1"), "\"'=1+1\""); // what is left out does not hide it
    EXPECT_EQ(csv_field("a=1"), "\"a=1\"");
}

TEST(Text, CannotLeaveItsPlaceInXml) {
    EXPECT_EQ(escape_xml("a<b>&\"\n"), "a&lt;b&gt;&amp;&quot;&#10;");
    EXPECT_EQ(escape_xml("]]>"), "]]&gt;");
}

} // namespace
} // namespace raylab
