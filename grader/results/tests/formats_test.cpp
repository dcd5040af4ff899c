// Each platform's file has the keys, types and limits that the platform's documents give.
#include "grader/results/formats.h"
#include "grader/results/tests/platform_files.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace raylab {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

Marks marks_of(int tasks) {
    Marks marks;
    marks.lab = "02_iterative";
    marks.title = "The iterative kernel";
    marks.grader = "raylab 1";
    marks.seconds = 12.7;
    for (int i = 1; i <= tasks; ++i) {
        Mark mark;
        mark.id = "2." + std::to_string(i);
        mark.title = "Task, the " + std::to_string(i) + ".";
        mark.of_points = 10 * i;
        mark.verdict = i % 2 ? MarkVerdict::pass : MarkVerdict::wrong;
        if (i % 2 == 0)
            mark.reasons = {"the mean should be 1 but is 2", "and <b>more</b> | \"so\""};
        mark.file = "labs/02_iterative/path.h";
        mark.line = 40 + i;
        mark.read_on = "2.1 The loop";
        marks.tasks.push_back(mark);
    }
    return marks;
}

// A submission that talks for megabytes (20 tasks), in bytes that are no text.
Marks hostile() {
    Marks marks = marks_of(20);
    for (Mark& mark : marks.tasks) {
        mark.verdict = MarkVerdict::wrong;
        mark.reasons = {std::string(200000, '\x01'), "\xFF\xFE</testcase>", "::error::forged"};
    }
    return marks;
}

TEST(Gradescope, HasItsKeys) {
    const json file = expect_gradescope(gradescope(marks_of(3)));
    EXPECT_EQ(file.at("score"), 40); // 10 + 30 of 60
    ASSERT_EQ(file.at("tests").size(), 3u);
    const json& test = file.at("tests")[1];
    EXPECT_EQ(test.at("score"), 0);
    EXPECT_EQ(test.at("max_score"), 20);
    EXPECT_EQ(test.at("status"), "failed");
    EXPECT_THAT(test.at("output").get<std::string>(), HasSubstr("should be 1 but is 2"));
}

TEST(Gradescope, ATaskThatHasNotRunYetIsAFailedTest) {
    Marks marks = marks_of(1);
    marks.tasks[0].verdict = MarkVerdict::not_run;
    const json test = json::parse(gradescope(marks)).at("tests")[0];
    EXPECT_EQ(test.at("status"), "failed");
    EXPECT_THAT(test.at("output").get<std::string>(), HasSubstr("NOT_RUN"));
}

TEST(PrairieLearn, HasItsKeys) {
    const json file = expect_prairielearn(prairielearn(marks_of(3)));
    EXPECT_EQ(file.at("gradable"), true);
    EXPECT_NEAR(file.at("score").get<double>(), 40.0 / 60, 1e-12);
    EXPECT_EQ(json::parse(prairielearn(marks_of(0))).at("score"), 0);
}

TEST(PrairieLearn, NeitherOwnTroubleNorACompileErrorUsesUpAnAttempt) {
    Marks marks = marks_of(2);
    marks.trouble = "the disk is full";
    const json trouble = expect_prairielearn(prairielearn(marks));
    EXPECT_EQ(trouble.at("gradable"), false);
    EXPECT_THAT(trouble.at("format_errors").dump(), HasSubstr("disk is full"));
    marks = marks_of(2);
    marks.compiler = "path.h:3:1: error: expected ';'";
    const json uncompiled = expect_prairielearn(prairielearn(marks));
    EXPECT_EQ(uncompiled.at("gradable"), false);
    EXPECT_THAT(uncompiled.at("format_errors").dump(), HasSubstr("path.h:3:1"));
}

TEST(Classroom50, HasItsKeysAndWholeNumbers) {
    const Classroom50 about = {
        "c", "a", "s", "https://x/1", "https://x/2", "https://x/3", "2026-11-28T10:00:00Z"};
    const json file = expect_classroom50(classroom50(marks_of(3), about));
    EXPECT_EQ(file.at("score"), 40);
    EXPECT_EQ(file.at("tests").size(), 3u);
    setenv("CLASSROOM", "from outside", 1);
    const Classroom50 here = Classroom50::from_environment();
    EXPECT_EQ(here.classroom, "from outside");
    EXPECT_THAT(here.datetime, testing::MatchesRegex("20..-..-..T..:..:..Z"));
    unsetenv("CLASSROOM");
}

TEST(JUnit, CountsAndEscapes) {
    const std::string text = junit(marks_of(4));
    EXPECT_THAT(text, HasSubstr("tests=\"4\" failures=\"2\" errors=\"0\""));
    EXPECT_THAT(text, HasSubstr("&lt;b&gt;more&lt;/b&gt;"));
    Marks marks = marks_of(1);
    marks.trouble = "no disk";
    EXPECT_THAT(junit(marks), HasSubstr("tests=\"2\" failures=\"0\" errors=\"1\""));
    EXPECT_THAT(junit(hostile()), Not(HasSubstr("\xFF")));
    EXPECT_THAT(junit(hostile()), Not(HasSubstr("</testcase>&#10;::error")));
}

TEST(Csv, HasScoreAndMaximumAndNoFormula) {
    Marks marks = marks_of(2);
    marks.grader = "=1+1";
    EXPECT_EQ(csv(marks), "lab,score,max_score,trouble,grader,2.1,2.1_verdict,2.2,2.2_verdict\r\n"
                          "\"02_iterative\",10,30,\"\",\"'=1+1\",10,PASS,0,WRONG\r\n");
}

TEST(GitHub, ShowsTheWorstTenAndSaysHowManyAreHidden) {
    const std::string few = github_annotations(marks_of(2));
    EXPECT_EQ(
        few,
        "::error file=labs/02_iterative/path.h,line=42,title=WRONG 2.2 Task%2C the 2.::the mean "
        "should be 1 but is 2%0Aand <b>more</b> | \"so\"%0Aread on in the handout: 2.1 The "
        "loop%0A\n");
    const std::string many = github_annotations(marks_of(24)); // 12 are wrong
    EXPECT_EQ(std::count(many.begin(), many.end(), '\n'), 10);
    EXPECT_THAT(many, testing::StartsWith("::error file=labs/02_iterative/path.h,line=64")); // 2.24
    EXPECT_THAT(many, HasSubstr("3 more tasks"));
    EXPECT_THAT(github_annotations(hostile()), Not(HasSubstr("\n::error::forged")));
}

TEST(GitHub, SummaryIsATableBelowAMegabyte) {
    EXPECT_THAT(
        github_summary(marks_of(2)),
        HasSubstr("| 2.2 Task, the 2. | WRONG | 0 of 20 | the mean should be 1 but is 2<br>and "
                  "&lt;b&gt;more&lt;/b&gt; \\| \"so\"<br>"));
    EXPECT_LT(github_summary(hostile()).size(), 1u << 20);
}

TEST(Formats, StayFilesWhateverASubmissionSays) {
    for (const std::string& format : mark_formats()) {
        const std::string text = write_marks(format, hostile());
        if (format != "junit") {
            EXPECT_LT(text.size(), 1000000u) << format;
        }
        if (format == "gradescope" || format == "prairielearn" || format == "classroom50") {
            EXPECT_FALSE(json::parse(text, nullptr, false).is_discarded()) << format;
        }
    }
    EXPECT_THROW(write_marks("moodle", {}), std::invalid_argument);
}

TEST(Marks, TheFirstErrorOfACompilerIsOneLine) {
    EXPECT_EQ(
        first_error("In file included from labs/02/a.cu:8:\nlabs/02/a.h:3:9: warning: unused\n"
                    "labs/02/a.h:3:1: error: expected ';'\n    3 | int x = ;\n"),
        "labs/02/a.h:3:1: error: expected ';'");
    EXPECT_EQ(first_error("killed\nby something"), "killed");
    EXPECT_EQ(first_error(""), "");
}

} // namespace
} // namespace raylab
