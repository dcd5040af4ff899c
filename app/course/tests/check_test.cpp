// `raylab check` and `raylab release` as a person meets them.
#include "app/tests/shell.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <string>
#include <sys/file.h>
#include <unistd.h>
#include <vector>

namespace raylab {
namespace {

namespace fs = std::filesystem;

using app::Outcome;
using app::run_in_shell;

Outcome raylab(const std::string& arguments) {
    return run_in_shell(std::string(RAYLAB_CHECK_PROGRAM) + " " + arguments);
}

void expect(const std::string& arguments, int code, const std::vector<std::string>& words) {
    const Outcome outcome = raylab(arguments);
    EXPECT_EQ(outcome.code, code) << arguments << "\n" << outcome.text;
    for (const std::string& word : words)
        EXPECT_NE(outcome.text.find(word), std::string::npos)
            << arguments << "\nshould say: " << word << "\nsaid: " << outcome.text;
}

TEST(Check, WrongUsageIsRefused) {
    expect("", 2, {});
    expect("check", 2, {"LAB"});
    expect("check 09", 2, {"no lab '09'", "01_recursive", "02_iterative"});
    expect("check 02 2.9", 2, {"no task '2.9'", "2.1, 2.2"});
    expect("release", 2, {"--output"});
    for (const std::string command : {"check", "prove", "release"})
        expect(command + " --help", 0, {"Examples"});
}

TEST(Check, WritesMarksInThePlatformsFormats) {
    const fs::path folder = fs::path(testing::TempDir()) / "raylab_marks";
    fs::remove_all(folder);
    const auto in = [&](const char* name) { return (folder / name).string(); };
    expect("check 02 2.5 2>&1 --write gradescope:" + in("g.json") + " --write csv:" + in("m.csv"),
           0, {"PASS"});
    std::ifstream csv(in("m.csv"));
    std::string names, values;
    std::getline(csv, names);
    std::getline(csv, values);
    EXPECT_EQ(values, "\"02_iterative\",15,15,\"\",\"raylab check\",15,PASS\r");
    std::ifstream json(in("g.json"));
    const std::string text{std::istreambuf_iterator<char>(json), {}};
    EXPECT_NE(text.find("\"score\": 15"), std::string::npos) << text;
    expect("check 02 --write gradscope:" + in("x"), 2, {"did you mean", "gradescope"});
    expect("check 02 --write gradescope", 2, {"FORMAT:FILE"});
    expect("check 02 --write junit:/proc/none/x", 2, {"/proc/none"});
    fs::remove_all(folder);
}

TEST(Check, OnATerminalIsTheSame) {
    for (const int width : {20, 80, 300}) {
        const Outcome outcome =
            app::run_on_terminal(std::string(RAYLAB_CHECK_PROGRAM) + " check 02", {80, width});
        EXPECT_EQ(outcome.code, 0) << outcome.text;
        EXPECT_NE(outcome.text.find("100 of 100 points"), std::string::npos) << outcome.text;
        EXPECT_LT(app::widest_progress(outcome.text), std::max(80, width));
    }
}

TEST(Help, OfTheScriptHasALineForEveryCommand) {
    const Outcome help = run_in_shell("./raylab --help");
    EXPECT_EQ(help.code, 0);
    for (const std::string command :
         {"demo",   "test",  "check",      "render",     "compare", "reference", "scenes",
          "export", "bench", "bench-rays", "rare-cases", "prove",   "release",   "grade-class",
          "run",    "debug", "import",     "update",     "site",    "vendor",    "autograder"})
        EXPECT_NE(help.text.find("\n  " + command + " "), std::string::npos) << command;
    EXPECT_EQ(run_in_shell("./raylab").code, 2);
}

// The path of its tree is compiled into the program. A copy in another folder would still judge the
// first tree.
TEST(Check, AProgramThatWasCopiedOrMovedJudgesNothing) {
    std::string folder = (fs::temp_directory_path() / "raylab copy-XXXXXX").string();
    ASSERT_NE(mkdtemp(folder.data()), nullptr);
    const std::string copy = folder + "/raylab-check";
    fs::copy_file(RAYLAB_CHECK_PROGRAM, copy);
    // If the copy were not refused, it would end with another message: there is no lab 09.
    for (const std::string command : {" check 09", " prove 09", " release --labs 09 -o /tmp"}) {
        const Outcome outcome = run_in_shell("'" + copy + "'" + command);
        EXPECT_EQ(outcome.code, 3) << outcome.text;
        EXPECT_NE(outcome.text.find("stands there no more"), std::string::npos) << outcome.text;
    }
    // A symbolic link is allowed: the program itself is still where it was built.
    fs::remove(copy);
    fs::create_symlink(RAYLAB_CHECK_PROGRAM, copy);
    EXPECT_EQ(run_in_shell("'" + copy + "' check 09").code, 2);
    fs::remove_all(folder);
}

TEST(Check, TheSolutionsPass) {
    expect("check 01", 0, {"PASS", "1.6", "100 of 100 points"});
    expect("check 02 2.6 --json", 0, {"\"verdict\": \"PASS\"", "\"passed\": true"});
}

TEST(Release, OneTreeALab) {
    std::string folder = (fs::temp_directory_path() / "raylab-release-XXXXXX").string();
    ASSERT_NE(mkdtemp(folder.data()), nullptr);
    // The full test builds, checks and runs each tree, which takes minutes.
    const std::string how = std::getenv("RAYLAB_LONG") ? "" : " --no-build";
    expect("release --labs 01,02 -o " + folder + how, 2,
           {"1.1   7 of  7 lines", "common/camera/camera.h", "--give-away"});
    EXPECT_TRUE(fs::is_empty(folder));
    expect("release --labs 01,02 --give-away -o " + folder + how, 0,
           {"01_recursive", "none of ", "answers of their tasks"});
    EXPECT_TRUE(fs::exists(folder + "/01_recursive/raylab"));
    EXPECT_TRUE(fs::exists(folder + "/02_iterative/labs/02_iterative/path.h"));
    EXPECT_FALSE(fs::exists(folder + "/02_iterative/labs/01_recursive"));
    EXPECT_FALSE(fs::exists(folder + "/01_recursive/common/trace/intersect.h"));
    EXPECT_TRUE(fs::exists(folder + "/01_recursive/.released.tar.gz"));
    expect("update " + folder + "/01_recursive", 2, {"no released tree: it has 4 labs"});
    expect("release --labs 01 -o " + folder + how, 2, {"is there already"});
    const int handle = open(folder.c_str(), O_RDONLY);
    ASSERT_EQ(flock(handle, LOCK_EX), 0);
    expect("release --labs 01 -o " + folder + how, 2, {"another release is writing to"});
    close(handle);
    fs::remove_all(folder);
}

} // namespace
} // namespace raylab
