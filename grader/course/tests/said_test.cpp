// What is a student's own word in the output of a test, and what others wrote.
#include "grader/course/said.h"

#include <gtest/gtest.h>

namespace raylab {

namespace {

using Lines = std::vector<std::string>;

TEST(Said, AStudentsWordsAloneAreLeft) {
    const std::string output = "Running main()\n[ RUN      ] Task.One\n"
                               "thread 3 has radiance 0.5\n"
                               "a.cpp:12: Failure\nFailed\nthe answer is 41\n\n"
                               "task 2.3 f() is not implemented: labs/02/a.cpp:3\n"
                               "labs/02/a.cu:7: error: index out of bounds\n  block 1\n  thread 2\n"
                               "thread 4 has radiance 0.25\n"
                               "[  FAILED  ] Task.One (3 ms)\n[==========] 1 test ran\n";
    EXPECT_EQ(said_by_test(output, "Task.One", {"a.cpp:12\nFailed\nthe answer is 41\n"}),
              (Lines{"thread 3 has radiance 0.5", "thread 4 has radiance 0.25"}));
    EXPECT_EQ(said_by_test(output, "Task.Two", {}), Lines{});
}

TEST(Said, AProgramThatCrashedHasSaidWhatItPrinted) {
    EXPECT_EQ(said_by_test("[ RUN      ] A.B\nbefore\n==7==ERROR: AddressSanitizer: x\n  #0 f\n",
                           "A.B", {}),
              Lines{"before"});
}

TEST(Said, ManyAndLongLinesAreCut) {
    std::string output = "[ RUN      ] A.B\n" + std::string(1000, 'x') + "\n";
    for (int i = 0; i < 29; ++i) output += "line\n";
    const Lines said = said_by_test(output, "A.B", {});
    ASSERT_EQ(said.size(), 21u);
    EXPECT_EQ(said[0].size(), 200u);
    EXPECT_EQ(said[20], "... and 10 more lines");
}

} // namespace

} // namespace raylab
