#include "grader/course/needs_first.h"

#include <gtest/gtest.h>

namespace raylab {

namespace {

TaskResult result(const std::string& id, TaskVerdict verdict, std::vector<std::string> needs) {
    TaskResult result;
    result.task.id = id;
    result.task.needs = std::move(needs);
    result.verdict = verdict;
    if (verdict == TaskVerdict::wrong) result.facts = {"a fact"};
    return result;
}

const std::string mend_first = "needs first: task 1.1, which is WRONG; mend it and check this task "
                               "again";

TEST(NeedsFirst, AWrongTaskNamesTheWrongOneThatItNeeds) {
    std::vector<TaskResult> results = {
        result("1.1", TaskVerdict::wrong, {}), result("1.2", TaskVerdict::wrong, {"1.1"}),
        result("1.3", TaskVerdict::wrong, {"1.4"}), result("1.4", TaskVerdict::pass, {"1.1"})};
    say_what_is_needed_first(results);
    EXPECT_EQ(results[0].facts, std::vector<std::string>{"a fact"});
    EXPECT_EQ(results[1].facts, (std::vector<std::string>{mend_first, "a fact"}));
    EXPECT_EQ(results[2].facts, std::vector<std::string>{"a fact"}); // 1.4 is right
    EXPECT_TRUE(results[3].facts.empty());                           // and so is this
}

TEST(NeedsFirst, OfTwoThatNeedEachOtherTheFirstIsMendedFirst) {
    std::vector<TaskResult> results = {result("1.1", TaskVerdict::wrong, {"1.2"}),
                                       result("1.2", TaskVerdict::wrong, {"1.1"})};
    say_what_is_needed_first(results);
    EXPECT_EQ(results[0].facts, std::vector<std::string>{"a fact"});
    EXPECT_EQ(results[1].facts, (std::vector<std::string>{mend_first, "a fact"}));
}

} // namespace

} // namespace raylab
