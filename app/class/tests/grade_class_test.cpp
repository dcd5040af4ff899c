// `raylab grade-class` as the grader of a class meets it.
#include "app/class/tests/class_in_folder.h"

#include <gmock/gmock.h>

#include <fcntl.h>
#include <sys/file.h>

namespace raylab {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

TEST(GradeClass, EveryEndOfAGraderHasItsVerdict) {
    ClassInFolder all;
    for (const char* deed : {"right", "half", "crash", "killed", "refuse", "none", "cut", "foreign",
                             "trouble", "hang"})
        all.student(deed, deed);
    fs::create_directory(all / "subs/empty");
    const app::Outcome outcome = all.run_all("--jobs 2 --limit 1");
    EXPECT_EQ(outcome.code, 3) << outcome.text; // some INTERNAL
    EXPECT_THAT(outcome.text, HasSubstr("11 submissions, 1 refused, 8 with trouble"));
    EXPECT_THAT(outcome.text, HasSubstr("--only INTERNAL"));
    const auto verdicts = all.verdicts();
    EXPECT_EQ(verdicts.at("right"), "100 PASS");
    EXPECT_EQ(verdicts.at("half"), "60 WRONG_IMAGE");
    EXPECT_EQ(verdicts.at("empty"), "0 NOT_RUN");
    for (const char* deed :
         {"crash", "killed", "refuse", "none", "cut", "foreign", "trouble", "hang"})
        EXPECT_EQ(verdicts.at(deed), " INTERNAL") << deed;
    const std::string csv = all.marks();
    for (const char* why : {"signal 6", "signal 9", "exit status 2", "marks.json is not read",
                            "marks.json is of lab 03_wavefront", "the sandbox did not start",
                            "did not end: timed out after 1 s", "empty: nothing was sent"})
        EXPECT_THAT(csv, HasSubstr(why));
}

TEST(GradeClass, WhatIsGradedIsNotGradedAgain) {
    ClassInFolder all;
    all.student("ada", "half");
    all.student("ben", "trouble");
    EXPECT_EQ(all.run_all().code, 3);
    const std::string marks = all.marks();
    EXPECT_EQ(all.run_all().code, 3);
    EXPECT_EQ(all.run("").code, 3);
    EXPECT_EQ(all.logged("begin ada"), 1);
    EXPECT_EQ(all.logged("begin ben"), 1);
    EXPECT_EQ(all.marks(), marks);
    // Trouble is over: --only finds those alone.
    const app::Outcome again = all.run("--only INTERNAL", "FAKE_BETTER=1 ");
    EXPECT_EQ(again.code, 0) << again.text;
    EXPECT_EQ(all.logged("begin ada"), 1);
    EXPECT_EQ(all.verdicts().at("ben"), "100 PASS");
    // What was sent anew is graded anew, and nothing else.
    all.student("ada", "right");
    EXPECT_EQ(all.run_all().code, 0);
    EXPECT_EQ(all.logged("begin ada"), 2);
    EXPECT_EQ(all.logged("begin ben"), 2);
    EXPECT_EQ(all.verdicts().at("ada"), "100 PASS");
}

TEST(GradeClass, TroubleChangesNoMark) {
    ClassInFolder all;
    all.student("ada", "crash");
    EXPECT_EQ(all.run_all("", "FAKE_BETTER=1 ").code, 0);
    EXPECT_EQ(all.verdicts().at("ada"), "100 PASS");
    EXPECT_EQ(all.run("--only PASS").code, 3);
    EXPECT_EQ(all.verdicts().at("ada"),
              "100 INTERNAL"); // the older points, and somebody should look
    EXPECT_EQ(all.run("--only INTERNAL", "FAKE_BETTER=1 ").code, 0);
    EXPECT_EQ(all.verdicts().at("ada"), "100 PASS");
}

TEST(GradeClass, ARegradeIsLookedAtBeforeItCounts) {
    ClassInFolder all;
    all.student("ada", "half");
    all.student("ben", "right");
    all.student("cyd", "trouble");
    all.run_all();
    const std::string before = all.marks();
    const app::Outcome stage = all.run("--stage", "FAKE_BETTER=1 ");
    EXPECT_THAT(stage.text, HasSubstr("ada (ada): 60 -> 100; 2.2: WRONG_IMAGE -> PASS, 2.4:"));
    EXPECT_THAT(stage.text, HasSubstr("cyd (cyd): - -> 100"));
    EXPECT_THAT(stage.text, HasSubstr("2 differ, 1 are the same\n"));
    EXPECT_EQ(all.marks(), before);
    EXPECT_EQ(all.run("--differences").text, stage.text);
    EXPECT_EQ(all.run("--stage").text, stage.text); // it is there already: nothing is graded
    EXPECT_EQ(all.run("--drop").code, 3);
    EXPECT_EQ(all.marks(), before);
    EXPECT_THAT(all.run("--differences").text, HasSubstr("0 differ, 0 are the same"));
    all.run("--stage --only WRONG_IMAGE", "FAKE_BETTER=1 ");
    EXPECT_EQ(all.run("--apply").code, 3); // cyd's trouble stays
    EXPECT_EQ(all.verdicts().at("ada"), "100 PASS");
    EXPECT_EQ(all.verdicts().at("cyd"), " INTERNAL");
    EXPECT_EQ(all.run("--stage --apply").code, 2);
}

TEST(GradeClass, TroubleInAStageTakesNoMark) {
    ClassInFolder all;
    all.student("ada", "crash");
    EXPECT_EQ(all.run_all("", "FAKE_BETTER=1 ").code, 0);
    EXPECT_THAT(all.run("--stage").text, HasSubstr("0 differ, 0 are the same, 1 keep their marks"));
    EXPECT_EQ(all.run("--apply").code, 0);
    EXPECT_EQ(all.verdicts().at("ada"), "100 PASS");
    EXPECT_THAT(all.run("--differences").text, HasSubstr("0 differ, 0 are the same\n")); // no stage
}

TEST(GradeClass, AMissingGraderIsSaidOnce) {
    ClassInFolder all;
    all.student("ada", "right");
    const app::Outcome outcome = app::run_in_shell(
        fmt::format("{} grade-class 02 '{}' -o '{}' --grader /no/such/grader", RAYLAB_CLASS_PROGRAM,
                    (all / "subs").string(), (all / "out").string()));
    EXPECT_EQ(outcome.code, 3);
    EXPECT_THAT(outcome.text, HasSubstr("1 submissions wait, and '/no/such/grader' is not there"));
    EXPECT_EQ(all.run("").code, 0); // it still waits
    EXPECT_EQ(all.verdicts().at("ada"), "100 PASS");
}

TEST(GradeClass, AStageThatIsNotDoneIsNotApplied) {
    ClassInFolder all;
    all.student("ada", "half");
    all.run_all();
    // Killed while it grades.
    app::run_in_shell("timeout -s KILL 0.7 env " + all.command("--stage", "FAKE_SECONDS=30 "));
    const app::Outcome apply = all.run("--apply");
    EXPECT_EQ(apply.code, 2);
    EXPECT_THAT(apply.text, HasSubstr("1 submissions of the stage are not graded yet"));
    EXPECT_THAT(all.run("--differences").text, HasSubstr("1 are not graded yet"));
    EXPECT_THAT(all.run("--stage", "FAKE_BETTER=1 ").text, HasSubstr("60 -> 100"));
    EXPECT_EQ(all.run("--apply").code, 0);
    EXPECT_EQ(all.verdicts().at("ada"), "100 PASS");
}

TEST(GradeClass, WhatStudentsWroteIsExportedWithoutWhatTheyWereGiven) {
    ClassInFolder all;
    all.student("ada", "right");
    all.write("subs/ada/whitted.h", "int mine;\n#pragma once\n");
    const std::string own = "'" + (all / "own").string() + "'";
    const app::Outcome outcome = all.run_all("--similarity " + own);
    EXPECT_EQ(outcome.code, 0) << outcome.text;
    EXPECT_EQ(all.text("own/ada/whitted.h"), "int mine;\n");
    EXPECT_EQ(all.text("own/ada/path.h"), "right ada\n");
    EXPECT_EQ(all.logged("begin ada"), 0);
    EXPECT_EQ(all.run("--similarity " + own).code, 2); // not empty
}

TEST(GradeClass, HostileTextsStayTexts) {
    ClassInFolder all;
    all.student("=HYPERLINK(1)", "half");
    all.student("<script>alert(1)<", "half");
    all.student("\xC3\x9Cnal \xE2\x82\xAC", "right");
    EXPECT_EQ(all.run_all().code, 0);
    EXPECT_THAT(all.marks(), HasSubstr("\"'=HYPERLINK(1)\""));
    const std::string page = all.text("out/class.html");
    EXPECT_THAT(page, Not(HasSubstr("<script>alert")));
    EXPECT_THAT(page, HasSubstr("&lt;script&gt;alert(1)&lt;"));
    EXPECT_THAT(page, HasSubstr("\xC3\x9Cnal \xE2\x82\xAC"));
    EXPECT_THAT(page, HasSubstr("default-src 'none'"));
}

TEST(GradeClass, BadInputIsASentence) {
    ClassInFolder all;
    all.student("ada", "right");
    EXPECT_EQ(all.run("").code, 0); // an empty class has no marks
    const auto refused = [&](const std::string& options, int code, const std::string& why) {
        const app::Outcome outcome = all.run(options);
        EXPECT_EQ(outcome.code, code) << options << outcome.text;
        EXPECT_THAT(outcome.text, HasSubstr(why)) << options;
    };
    refused("/no/such/export", 2, "there are no submissions '/no/such/export'");
    refused("--only PASSED", 2, "did you mean \"PASS\"");
    refused("--jobs 0", 2, "");
    all.write("broken.zip", "this is no archive");
    refused("'" + (all / "broken.zip").string() + "'", 2, "damaged, or no zip or tar");
    EXPECT_EQ(app::run_in_shell(std::string(RAYLAB_CLASS_PROGRAM) + " grade-class 09 x -o y").code,
              2);
    EXPECT_EQ(app::run_in_shell(std::string(RAYLAB_CLASS_PROGRAM) + " grade-class --help").code, 0);
    // The folder has another lab's marks.
    const app::Outcome other = app::run_in_shell(
        fmt::format("{} grade-class 03 -o '{}'", RAYLAB_CLASS_PROGRAM, (all / "out").string()));
    EXPECT_EQ(other.code, 2);
    EXPECT_THAT(other.text, HasSubstr("has the marks of lab 02_iterative, not of 03_wavefront"));
}

TEST(GradeClass, AJournalThatIsNotOursIsLeftAlone) {
    ClassInFolder all;
    all.student("ada", "right");
    all.run_all();
    const std::string journal = "'" + (all / "out/journal.sqlite").string() + "'";
    ASSERT_EQ(app::run_in_shell("python3 -c \"import sqlite3,sys; c=sqlite3.connect(sys.argv[1]); "
                                "c.execute('PRAGMA user_version=7'); c.commit()\" " +
                                journal)
                  .code,
              0);
    app::Outcome outcome = all.run("");
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.text, HasSubstr("has version 7, and this raylab keeps version 1"));
    all.write("out/journal.sqlite", std::string(5000, 'x'));
    outcome = all.run("");
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.text, HasSubstr("it is damaged, or another program's file"));
    EXPECT_EQ(all.text("out/journal.sqlite"), std::string(5000, 'x'));
}

TEST(GradeClass, TwoGradersDoNotShareAFolder) {
    ClassInFolder all;
    all.student("ada", "right");
    fs::create_directory(all / "out");
    const int handle = open((all / "out").c_str(), O_RDONLY);
    ASSERT_EQ(flock(handle, LOCK_EX), 0);
    const app::Outcome second = all.run_all();
    EXPECT_EQ(second.code, 2);
    EXPECT_THAT(second.text, HasSubstr("another grader works in"));
    close(handle);
    EXPECT_EQ(all.run_all().code, 0);
}

// A file may grow to 24 KiB only: the disk is as good as full.
TEST(GradeClass, AFullDiskLosesNothing) {
    ClassInFolder all;
    for (int i = 0; i < 30; ++i) all.student("s" + std::to_string(i), "half");
    const app::Outcome full = app::run_in_shell(
        "(ulimit -f 48; " + all.command("'" + (all / "subs").string() + "'") + ")");
    EXPECT_EQ(full.code, 3) << full.text;
    EXPECT_THAT(full.text,
                testing::AnyOf(HasSubstr("the disk is full"), HasSubstr("is the disk full")));
    EXPECT_EQ(all.run_all().code, 0);
    EXPECT_EQ(all.verdicts().size(), 30u);
    for (int i = 0; i < 30; ++i) EXPECT_EQ(all.logged("end s" + std::to_string(i)) >= 1, true) << i;
}

} // namespace
} // namespace raylab
