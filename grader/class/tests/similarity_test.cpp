// What a student wrote, without what every student was given.
#include "grader/class/similarity.h"

#include <gtest/gtest.h>

namespace raylab {
namespace {

constexpr const char* given = "#pragma once\n"
                              "\n"
                              "int task() {\n"
                              "    not_implemented(\"2.1\");\n"
                              "}\n"
                              "int other();\n";

TEST(OwnLines, AreWhatWasAdded) {
    EXPECT_EQ(own_lines(given, given), "");
    EXPECT_EQ(own_lines("#pragma once\n"
                        "\n"
                        "int task() {\n"
                        "    int a = 1;\n"
                        "    return a;\n"
                        "}\n"
                        "int other();\n",
                        given),
              "    int a = 1;\n    return a;\n");
    EXPECT_EQ(own_lines("int x;", ""), "int x;\n");
    EXPECT_EQ(own_lines("", given), "");
}

TEST(OwnLines, DoNotDependOnSpaces) {
    EXPECT_EQ(own_lines("\t#pragma once  \n int task() {\nmine();\n", given), "mine();\n");
}

TEST(OwnLines, AGivenLineThatIsWrittenTwiceIsOwnOnce) {
    EXPECT_EQ(own_lines("int other();\nint other();\n", given), "int other();\n");
}

} // namespace
} // namespace raylab
