// Progress without a terminal: the lines that a log gets.
#include "common/cli/progress.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>

namespace raylab {
namespace {

using testing::HasSubstr;
using testing::MatchesRegex;

void wait(int milliseconds) {
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
}

TEST(Progress, WhatIsQuickSaysNothing) {
    testing::internal::CaptureStderr();
    {
        Progress progress("02 cornell", 100, "samples", 1);
        for (int done = 1; done <= 100; ++done) progress.update(done);
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(Progress, LinesSayWhatAndHowFarAndHowLong) {
    testing::internal::CaptureStderr();
    {
        Progress progress("02 cornell", 4, "samples", 1000, 0.1);
        progress.update(1);
        wait(150);
        progress.update(1);
        progress.update(2); // too soon after the last
    }
    EXPECT_THAT(testing::internal::GetCapturedStderr(),
                MatchesRegex("02 cornell: 25 %, [0-9.]+ k samples/s, 0.[0-9] s left\n"));
}

// One step may take minutes.
TEST(Progress, GoesOnWithinAStep) {
    testing::internal::CaptureStderr();
    {
        Progress progress("02 cornell", 4, "samples", 1, 0.1);
        for (int i = 0; i < 25; ++i, wait(10)) progress.tick();
    }
    const std::string lines = testing::internal::GetCapturedStderr();
    EXPECT_GE(std::count(lines.begin(), lines.end(), '\n'), 2) << lines;
    EXPECT_THAT(lines, HasSubstr("02 cornell: 0 %, 0.1 s so far\n"));
}

// As when Ninja finds more to do than it said first.
TEST(Progress, MoreStepsThanSaidAreNoMoreThanAll) {
    testing::internal::CaptureStderr();
    {
        Progress progress("building", 2, "files", 1, 0.05);
        wait(60);
        progress.update(3, 4);
        wait(60);
        progress.update(5);
    }
    EXPECT_THAT(testing::internal::GetCapturedStderr(), MatchesRegex("building: 75 %, .* left\n"));
}

TEST(HumanDuration, HasHours) {
    EXPECT_EQ(human_duration(0.84), "0.8 s");
    EXPECT_EQ(human_duration(3000), "50 min 0 s");
    EXPECT_EQ(human_duration(2 * 3600 + 5 * 60), "2 h 5 min");
}

} // namespace
} // namespace raylab
