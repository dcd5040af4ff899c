// Each outcome of a test program, and the verdict and words that it must lead to.
#include "grader/course/tests/temporary_tree.h"
#include "grader/course/verdict.h"

namespace raylab {

namespace {

class Verdicts : public TemporaryTree {
  protected:
    TaskResult judge(const std::string& id, const std::string& filter,
                     const std::vector<std::string>& needs = {}) const {
        const LabSheet lab = read_lab_sheet(root, "07_tiny");
        Task task = lab.tasks.front();
        task.id = id;
        task.tests = {filter};
        task.needs = needs;
        return judge_task(lab, task, RAYLAB_FAKE_LAB);
    }

    // Expects an error of the tool, and no CourseError, which would blame the lab or its sheet.
    void expect_not_judged(const std::string& filter) const {
        try {
            judge("7.9", filter);
            ADD_FAILURE() << filter << " was judged";
        } catch (const CourseError& error) {
            ADD_FAILURE() << error.what();
        } catch (const std::runtime_error& error) {
            EXPECT_NE(std::string(error.what()).find("did not run"), std::string::npos)
                << error.what();
        }
    }
};

TEST_F(Verdicts, AllTestsPass) {
    const TaskResult result = judge("7.9", "Right.*");
    EXPECT_EQ(result.verdict, TaskVerdict::pass);
    EXPECT_EQ(result.tests, 2);
    EXPECT_EQ(result.points(), 3);
}

TEST_F(Verdicts, WhatTheWatchFoundIsWrong) {
    const TaskResult result = judge("7.9", "Watched.*");
    EXPECT_EQ(result.verdict, TaskVerdict::wrong);
    EXPECT_EQ(result.facts, std::vector<std::string>{"labs/07_fake/a.cu:12: a race; a barrier"});
}

TEST_F(Verdicts, AResultThatDependsOnTheOrderOfThreadsIsWrong) {
    const TaskResult result = judge("7.9", "Ordered.*");
    EXPECT_EQ(result.verdict, TaskVerdict::wrong);
    ASSERT_EQ(result.facts.size(), 1u);
    EXPECT_NE(result.facts[0].find("in reverse order"), std::string::npos);
    EXPECT_NE(result.facts[0].find("a sum is missing"), std::string::npos);
    EXPECT_EQ(judge("7.9", "Unordered.*").verdict, TaskVerdict::pass);
    EXPECT_EQ(judge("7.9", "WithoutKernel.*").verdict, TaskVerdict::pass);
}

TEST_F(Verdicts, WrongSaysTheMeasuredFactAlone) {
    const TaskResult result = judge("7.9", "Wrong.*");
    EXPECT_EQ(result.verdict, TaskVerdict::wrong);
    EXPECT_EQ(result.passed, 1);
    EXPECT_EQ(result.points(), 0);
    EXPECT_EQ(result.facts,
              std::vector<std::string>{
                  "the answer should be 42 but is 41; the likely cause: one too few"});
}

TEST_F(Verdicts, AStubIsNamedWithItsPlaceInTheLab) {
    const TaskResult result = judge("7.3", "Stubbed.*");
    EXPECT_EQ(result.verdict, TaskVerdict::not_implemented);
    ASSERT_EQ(result.stubs.size(), 1u);
    EXPECT_EQ(result.stubs[0].sentence(), "task 7.3 f() is not implemented: labs/07_fake/a.cpp:12");
    EXPECT_TRUE(result.facts.empty());
}

TEST_F(Verdicts, WhatIsDoneOfATaskIsJudgedBesideItsStub) {
    const TaskResult result = judge("7.4", "Half.*");
    EXPECT_EQ(result.verdict, TaskVerdict::not_implemented);
    EXPECT_EQ(result.facts, std::vector<std::string>{"a fact of the other half"});
}

TEST_F(Verdicts, AStubOfANeededTaskIsNamedAndOfAnotherIsNot) {
    const TaskResult needing = judge("7.9", "Needing.*", {"7.3"});
    EXPECT_EQ(needing.verdict, TaskVerdict::waits);
    EXPECT_EQ(needing.stubs.at(0).task, "7.3");
    EXPECT_EQ(needing.before(needing.stubs[0]), "written, waits for 7.3: ");
    EXPECT_EQ(judge("7.9", "Needing.*").verdict, TaskVerdict::wrong);
}

// No test calls f(), but its stub stands in the file.
TEST_F(Verdicts, AStubThatNothingCallsIsFoundInTheSource) {
    write("labs/07_tiny/a.cpp", "int f() {\n    not_implemented(\"7.2\", \"f()\");\n"
                                "    // not_implemented(\"7.2\", \"gone()\");\n}\n");
    const TaskResult stubbed = judge("7.2", "Crashing.*");
    EXPECT_EQ(stubbed.verdict, TaskVerdict::not_implemented);
    ASSERT_EQ(stubbed.stubs.size(), 1u);
    EXPECT_EQ(stubbed.stubs[0].place, "labs/07_tiny/a.cpp:2");
}

TEST_F(Verdicts, CrashesAndExceptionsAreTheTasksAlone) {
    const TaskResult crash = judge("7.9", "Crashing.*");
    EXPECT_EQ(crash.verdict, TaskVerdict::wrong);
    EXPECT_NE(crash.facts.at(0).find("Crashing.One crashed (Segmentation fault)"),
              std::string::npos)
        << crash.facts[0];
    const TaskResult thrown = judge("7.9", "Throwing.*");
    EXPECT_EQ(thrown.verdict, TaskVerdict::wrong);
    EXPECT_EQ(thrown.facts,
              std::vector<std::string>{"the test was ended by an error: no such scene"});
    const TaskResult divided = judge("7.9", "Dividing.*");
    EXPECT_NE(divided.facts.at(0).find("divided by zero"), std::string::npos) << divided.facts[0];
}

TEST_F(Verdicts, AMissingTestProgramIsNobodysWrongAnswer) {
    const LabSheet lab = read_lab_sheet(root, "07_tiny");
    EXPECT_THROW(judge_task(lab, lab.tasks.front(), root / "not-built"), std::runtime_error);
}

// A test that did not run gives no points, whatever the program's exit code is, and is not counted
// as the student's mistake.
TEST_F(Verdicts, WhatDidNotRunIsNotJudged) {
    for (const char* filter : {"None.*", "Skipping.*", "Disabled.*", "WithoutGpu.*"})
        expect_not_judged(filter);
}

TEST_F(Verdicts, AProgramThatEndsBeforeItsTestsIsNotJudged) {
    for (const char* how : {"0", "by a signal"}) {
        setenv("RAYLAB_FAKE_LAB_ENDS", how, 1);
        expect_not_judged("Right.*");
    }
    unsetenv("RAYLAB_FAKE_LAB_ENDS");
}

TEST_F(Verdicts, EndingTheProgramWithinATestPassesNothing) {
    const TaskResult result = judge("7.9", "Leaving.*");
    EXPECT_EQ(result.verdict, TaskVerdict::wrong);
    EXPECT_NE(result.facts.at(0).find("exit()"), std::string::npos) << result.facts[0];
}

TEST_F(Verdicts, MegabytesOfOutputChangeNothing) {
    EXPECT_EQ(judge("7.9", "Talking.*").verdict, TaskVerdict::pass);
}

TEST_F(Verdicts, WhatTheLabItselfPrintsIsShown) {
    const TaskResult result = judge("7.9", "Printing.*");
    EXPECT_EQ(result.verdict, TaskVerdict::wrong);
    EXPECT_EQ(result.said, std::vector<std::string>{"thread 3: 0.5"});
    EXPECT_EQ(result.facts, std::vector<std::string>{"a fact"});
}

} // namespace

} // namespace raylab
