// Numbers by std::strtod() are those of std::from_chars(), which the other tests of files have
// here.
#include "common/cli/parse_double.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <string_view>

namespace raylab {
namespace {

TEST(ParseDouble, ByStrtodAsByFromChars) {
    for (const std::string_view text : {"0",
                                        "-0",
                                        "1",
                                        "-1.5",
                                        ".5",
                                        "5.",
                                        "1e3",
                                        "1E-3",
                                        "1e",
                                        "1e+",
                                        "1.5e+2x",
                                        "0.1",
                                        "1.7976931348623157e308",
                                        "1e309",
                                        "-1e309",
                                        "4.9e-324",
                                        "3e-310",
                                        "1e-400",
                                        "inf",
                                        "-infinity",
                                        "nan",
                                        "0x10",
                                        "-0x1p3",
                                        "+1",
                                        " 1",
                                        "\t1",
                                        "",
                                        "-",
                                        ".",
                                        "e5",
                                        "1 2",
                                        "1,5",
                                        "--1",
                                        "123456789012345678901234567890",
                                        "1_000"}) {
        double value = 7, expected = 7;
        const char *begin = text.data(), *end = begin + text.size();
        const auto found = parse_double_by_strtod(begin, end, value);
        const auto truth = parse_double(begin, end, expected);
        EXPECT_EQ(found.ptr - begin, truth.ptr - begin) << text;
        EXPECT_EQ(found.ec, truth.ec) << text;
        EXPECT_EQ(std::bit_cast<std::uint64_t>(value), std::bit_cast<std::uint64_t>(expected))
            << text;
    }
}

} // namespace
} // namespace raylab
