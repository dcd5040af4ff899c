// What students get has no line of a solution, wherever it might stand; variations do apply.
#include "common/cli/files.h"
#include "grader/course/answers.h"
#include "grader/course/release.h"
#include "grader/course/tests/temporary_tree.h"
#include "grader/course/variation.h"

namespace raylab {

namespace {

class Release : public TemporaryTree {
  protected:
    void SetUp() override {
        TemporaryTree::SetUp();
        write("labs/07_tiny/a.cpp", "//[ task 7.1\nint one = first_factor * second_factor;\n"
                                    "//| int one = 0;\n//]\n"
                                    "//[ task 7.2\nint two = one + first_factor / 3 + 17;\n//]\n");
        write("common/whole.h", "int answer_as_a_whole();\n");
        write("common/part.h", "//[ withhold 07\nint answer = a_quarter * another_quarter;\n"
                               "//| int answer = yours();\n//]\nint rest;\n"
                               "//[ withhold 08\nint eight;\n//]\n");
        write("common/given.h", "int given;\n");
        write("common/tests/answer_test.cpp", "the answer\n");
        write("app/tests/answer_test.cpp", "the answer\n");
        write("docs/guide/student.md", "# A day\n");
        write("docs/instructor/README.md", "# A semester\n");
        write("docs/instructor/answers/07.md", "the answer\n");
        write("app/course/prove.cpp", "works with solutions\n");
        write("app/course/check.cpp", "works with stubs\n");
        write("labs/08_other/a.cpp", "int other;\n");
        write("CMakePresets.json",
              R"({"configurePresets": [{"name": "base"}, {"name": "cpu", "inherits": "base"}]})");
        write(".vscode/tasks.json",
              R"({"tasks": [{"label": "check lab"}, {"label": "test"}],
                  "inputs": [{"id": "lab", "options": ["07", "08"], "default": "08"}]})");
        write_sheet(R"("withhold": {"common/whole.h": ["7.1"], "common/part.h": ["7.2"]},)");
    }
    void write_sheet(const std::string& withhold) {
        write_changed("labs/07_tiny/lab.json", sheet, "\"tasks\":", withhold + "\"tasks\":");
    }
    // A lab like 07, whose task 2 is answered by common/kernel.cu.
    void write_other(const std::string& number) const {
        const std::string first = std::to_string(std::stoi(number)) + ".";
        std::string text = sheet, code =
                                      "//[ task 7.1\nint other = an_idea * of_another_lab;\n//]\n"
                                      "//[ task 7.2\nint two;\n//]\n";
        const auto replace = [](std::string& in, const std::string& from, const std::string& to) {
            for (std::size_t at = 0; (at = in.find(from, at)) != in.npos; at += to.size())
                in.replace(at, from.size(), to);
        };
        replace(text, "07_tiny", number + "_other");
        replace(text, "\"07\"", "\"" + number + "\"");
        replace(text, "\"7.", "\"" + first);
        replace(code, "task 7.", "task " + first);
        text.insert(text.find("\"tasks\":"),
                    "\"withhold\": {\"common/kernel.cu\": [\"" + first + "2\"]},");
        write("labs/" + number + "_other/lab.json", text);
        write("labs/" + number + "_other/a.cpp", code);
        write("labs/" + number + "_other/README.md", "# Other\n\n## One\n\n## Two\n");
        write("labs/" + number + "_other/tests/a_test.cpp", "// public\n");
    }
    ReleasedTree release() const {
        return write_student_tree(read_lab_sources(read_lab_sheet(root, "07_tiny")), root / "out");
    }
    bool has(const std::string& file) const { return std::filesystem::exists(root / "out" / file); }
};

TEST_F(Release, LeavesOutAnswersTestsAndOtherLabs) {
    const ReleasedTree tree = release();
    EXPECT_TRUE(has("common/given.h") && has("labs/07_tiny/tests/a_test.cpp") && has("README.md"));
    EXPECT_FALSE(has("common/whole.h"));
    EXPECT_FALSE(has("common/tests/answer_test.cpp") || has("app/tests/answer_test.cpp"));
    EXPECT_TRUE(has("app/course/check.cpp"));
    EXPECT_FALSE(has("app/course/prove.cpp"));
    EXPECT_TRUE(has("docs/guide/student.md"));
    EXPECT_FALSE(has("docs/instructor")); // its answers to the handouts' questions
    EXPECT_FALSE(has("labs/07_tiny/variations/v.json") || has("labs/08_other/a.cpp"));
    EXPECT_EQ(read_file((root / "out/common/part.h").string()),
              "int answer = yours();\nint rest;\nint eight;\n");
    EXPECT_NE(read_file((root / "out/CMakePresets.json").string()).find("RAYLAB_STRICT"),
              std::string::npos);
    EXPECT_TRUE(leaks(root / "out", tree.solution_lines).empty());
}

TEST_F(Release, TheEditorOffersTheLabOfTheTreeAlone) {
    release();
    const std::string tasks = read_file((root / "out/.vscode/tasks.json").string());
    EXPECT_NE(tasks.find("check lab"), std::string::npos);
    EXPECT_NE(tasks.find("\"default\": \"07\""), std::string::npos);
    EXPECT_EQ(tasks.find("08"), std::string::npos);
    EXPECT_EQ(tasks.find("\"test\""), std::string::npos);
}

TEST_F(Release, ALineOfASolutionIsFoundWhereverItStandsAndHoweverItIsSpaced) {
    write("common/given.h", "int given;\n   int two=one + first_factor/3+17; // copied\n");
    write("scenes/README.md", "int one = first_factor * second_factor;\n");
    const ReleasedTree tree = release();
    std::vector<std::string> found = leaks(root / "out", tree.solution_lines);
    std::sort(found.begin(), found.end());
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0], "common/given.h:2: int two=one + first_factor/3+17; // copied");
    EXPECT_EQ(found[1], "scenes/README.md:1: int one = first_factor * second_factor;");
}

// Students of lab 07 will write lab 08 later; students of lab 09 have written it already.
TEST_F(Release, WhatALaterLabWithholdsStaysBehindToo) {
    write("common/kernel.cu", "__global__ void the_answer_of_another_lab();\n");
    write_other("06");
    release();
    EXPECT_TRUE(has("common/kernel.cu"));
    std::filesystem::remove_all(root / "out");
    write_other("08");
    release();
    EXPECT_FALSE(has("common/kernel.cu"));
    EXPECT_TRUE(has("common/given.h"));
}

TEST_F(Release, ALineOfALaterLabsSolutionIsALeakAndOfAnEarlierOneIsTold) {
    write("common/kernel.cu", "__global__ void the_answer_of_another_lab();\n");
    write("common/given.h", "int other = an_idea * of_another_lab;\n");
    write_other("06");
    EXPECT_TRUE(leaks(root / "out", release().solution_lines).empty());
    const std::vector<Answer> answers =
        earlier_answers(read_lab_sheet(root, "07_tiny"), root / "out");
    ASSERT_EQ(answers.size(), 2u);
    EXPECT_EQ(answers[0].task, "6.1");
    EXPECT_EQ(answers[0].lines, 1);
    EXPECT_EQ(answers[0].of_lines, 1);
    EXPECT_EQ(answers[0].files, std::set<std::string>{"common/given.h"});
    EXPECT_EQ(answers[1].task, "6.2");
    EXPECT_EQ(answers[1].files, std::set<std::string>{"common/kernel.cu"});
    EXPECT_NE(to_text(answers).find("6.1   1 of  1 lines"), std::string::npos);

    std::filesystem::remove_all(root / "out");
    std::filesystem::remove_all(root / "labs/06_other");
    write_other("08");
    EXPECT_EQ(leaks(root / "out", release().solution_lines),
              std::vector<std::string>{"common/given.h:1: int other = an_idea * of_another_lab;"});
    EXPECT_TRUE(earlier_answers(read_lab_sheet(root, "07_tiny"), root / "out").empty());
}

TEST_F(Release, WithheldFilesAndTheListAgree) {
    write_sheet(R"("withhold": {"common/whole.h": ["7.1"]},)");
    try {
        release();
        ADD_FAILURE() << "a region that the sheet does not list was accepted";
    } catch (const CourseError& error) {
        EXPECT_NE(std::string(error.what()).find("common/part.h:1: "), std::string::npos)
            << error.what();
    }
    write_sheet(R"("withhold": {"common/part.h": ["7.1"], "common/none.h": ["7.1"]},)");
    EXPECT_THROW(release(), CourseError);
    write_sheet(R"("withhold": {"common/part.h": ["7.9"]},)");
    EXPECT_THROW(release(), CourseError); // no such task
}

TEST_F(Release, AVariationChangesExactlyOnePlace) {
    const Variation variation = {"v", "v.json:1:1: /find", "t", "a.cpp", "b = 2;\n", "b = 3;\n"};
    EXPECT_EQ(variation.apply("a = 1;\nb = 2;\n"), "a = 1;\nb = 3;\n");
    EXPECT_THROW(variation.apply("a = 1;\nbb = 2;\n"), CourseError);         // nowhere
    EXPECT_THROW(variation.apply("b = 2;\nab = 2;\nb = 2;\n"), CourseError); // twice
    EXPECT_THROW(variation.apply("  b = 2;\n"), CourseError);                // not the whole line
    write("labs/07_tiny/variations/v.json",
          R"({"title": "t", "file": "none.cpp", "find": ["a"], "replace": ["b"]})");
    EXPECT_THROW(read_variations(read_lab_sheet(root, "07_tiny")), CourseError);
}

} // namespace

} // namespace raylab
