// `raylab grade` as an instructor meets it: right submissions get all points, unfinished ones
// theirs, hostile ones none.
#include "app/grade/tests/attacks.h"
#include "app/tests/shell.h"
#include "common/cli/files.h"
#include "grader/course/stub_tree.h"
#include "grader/course/variation.h"
#include "grader/results/marks_json.h"
#include "grader/sandbox/tier.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>

namespace raylab {
namespace {

namespace fs = std::filesystem;

using testing::AnyOf;
using testing::Contains;
using testing::HasSubstr;

// A folder for submissions of lab 02, and how they are graded.
class Grade : public testing::Test {
  protected:
    LabSheet sheet = find_lab(RAYLAB_ROOT, "02");
    LabSources lab = read_lab_sources(sheet);
    fs::path folder = fs::path(testing::TempDir()) / fmt::format("raylab-grade-test-{}", getpid());

    ~Grade() override { fs::remove_all(folder); }

    fs::path submission(const std::set<std::string>& stubbed, const ChangeText& change = nullptr) {
        const fs::path root = folder / "submission";
        fs::remove_all(root);
        write_lab(lab, stubbed, root, change);
        return root / "labs" / sheet.folder;
    }

    // The first task's verdict is printed, with the tier: the log is a table.
    Marks grade(const fs::path& from, int code, const std::string& name) {
        const fs::path out = folder / "out";
        const app::Outcome outcome = app::run_in_shell(fmt::format(
            "{} grade 02 '{}' -o '{}'", RAYLAB_GRADE_PROGRAM, from.string(), out.string()));
        EXPECT_EQ(outcome.code, code) << outcome.text;
        if (outcome.code != 0 && outcome.code != 1) return {};
        const std::string file = (out / "marks.json").string();
        const Marks marks = read_marks_json(read_file(file), file);
        fmt::print("{:45} {:15} {:3}/{} points, {:5.1f} s, {}\n", name,
                   raylab::name(marks.tasks.front().verdict), marks.points(), marks.of_points(),
                   marks.seconds, marks.sandbox.substr(0, marks.sandbox.find('(')));
        std::fflush(stdout);
        return marks;
    }
};

TEST_F(Grade, TheSolutionGetsAllPoints) {
    const Marks marks = grade(submission({}), 0, "the solution");
    EXPECT_EQ(marks.points(), 100);
    EXPECT_TRUE(fs::exists(folder / "out/report.html"));
}

TEST_F(Grade, StubsGetNone) {
    const Marks marks =
        grade(submission({"2.1", "2.2", "2.3", "2.4", "2.5", "2.6"}), 1, "the stubs");
    EXPECT_EQ(marks.points(), 0);
    for (const Mark& mark : marks.tasks) EXPECT_EQ(mark.verdict, MarkVerdict::not_implemented);
}

TEST_F(Grade, AnErrorOfTheCompilerHasItsPlace) {
    const Marks marks =
        grade(submission({},
                         [](const std::string& file, std::string text) {
                             return file == "path.h" ? text + "\nint broken = ;\n" : text;
                         }),
              1, "a typing error");
    EXPECT_EQ(marks.tasks[0].verdict, MarkVerdict::compile_error);
    EXPECT_EQ(marks.tasks[0].file, "labs/02_iterative/path.h");
    EXPECT_GT(marks.tasks[0].line, 50);
}

TEST_F(Grade, WhatIsNoSubmissionIsSaid) {
    fs::create_directories(folder / "empty");
    grade(folder / "empty", 2, "an empty folder");
    grade(folder / "none", 2, "no folder");
}

struct RightVariations : Grade {};

// Other random numbers, other lobes, other block sizes: right, and not the solution's paths.
TEST_F(RightVariations, GetAllPoints) {
    const bool all = std::getenv("RAYLAB_LONG") != nullptr;
    for (const Variation& variation : read_variations(sheet)) {
        if (!all && variation.file != "renderer.cu") continue;
        const Marks marks =
            grade(submission({},
                             [&](const std::string& file, std::string text) {
                                 return file == variation.file ? variation.apply(text) : text;
                             }),
                  0, variation.title);
        EXPECT_EQ(marks.points(), 100) << variation.title;
        if (!all) break;
    }
}

// All of them in a long test, by their names.
std::vector<Attack> attacks_to_try() {
    std::vector<Attack> some;
    for (const Attack& attack : attacks())
        if (attack.always || std::getenv("RAYLAB_LONG") != nullptr) some.push_back(attack);
    return some;
}

struct Attacks : Grade, testing::WithParamInterface<Attack> {};

TEST_P(Attacks, EarnsNothing) {
    const Attack& attack = GetParam();
    bool found = false;
    const fs::path from = submission({}, [&](const std::string& file, std::string text) {
        const std::size_t at = text.find(attack.find);
        if (file != attack.file || at == text.npos) return text;
        found = true;
        return text.replace(at, attack.find.size(), attack.replace);
    });
    ASSERT_TRUE(found) << "its place in the lab is gone";
    const Marks marks = grade(from, 1, attack.name);
    ASSERT_FALSE(marks.tasks.empty());
    EXPECT_THAT(attack.verdicts, Contains(raylab::name(marks.tasks.front().verdict)))
        << testing::PrintToString(marks.tasks.front().reasons);
    EXPECT_EQ(marks.tasks.front().points(), 0);
    EXPECT_LE(marks.points(), attack.most_points);
}

INSTANTIATE_TEST_SUITE_P(Lab02, Attacks, testing::ValuesIn(attacks_to_try()),
                         [](const testing::TestParamInfo<Attack>& info) {
                             std::string name = info.param.name;
                             for (char& c : name)
                                 if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
                             return name;
                         });

} // namespace
} // namespace raylab
