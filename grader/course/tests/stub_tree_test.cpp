// From markers to the tree that students get, and every way to get markers or lab.json wrong: one
// sentence, with the place.
#include "common/cli/files.h"
#include "grader/course/tests/temporary_tree.h"

#include <functional>

namespace raylab {

namespace {

using StubTree = TemporaryTree;

void expect_error(const std::function<void()>& act, const std::vector<std::string>& words) {
    try {
        act();
        ADD_FAILURE() << "no error; expected one that says " << words.front();
    } catch (const CourseError& error) {
        for (const std::string& word : words)
            EXPECT_NE(std::string(error.what()).find(word), std::string::npos)
                << "should say: " << word << "\nsaid: " << error.what();
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    }
}

std::string stubbed(const std::string& source, const std::string& id) {
    return student_source(parse_markers(source, "a.cpp"),
                          [&](const MarkedRegion& region) { return region.id == id; });
}

TEST_F(StubTree, OneTaskIsStubbedAndTheOtherStands) {
    EXPECT_EQ(stubbed(source, "7.2"), "int before();\n"
                                      "int one() { return 1; }\n"
                                      "int f() {\n"
                                      "    not_implemented(\"7.2\", \"f()\");\n"
                                      "\n"
                                      "      return 0;\n"
                                      "}\n");
    EXPECT_EQ(stubbed(source, ""), "int before();\nint one() { return 1; }\n"
                                   "int f() {\n    return 2;\n}\n");
}

TEST_F(StubTree, MisplacedMarkersAreNamedWithTheirLine) {
    const struct {
        std::string text;
        std::vector<std::string> words;
    } cases[] = {
        {"a\n//[ task 1.1\nb\n", {"x.h:2: ", "never closed"}},
        {"a\n//]\n", {"x.h:2: ", "none is open"}},
        {"//[ task 1.1\n//[ task 1.2\n//]\n", {"x.h:2: ", "inside that of task 1.1 from line 1"}},
        {"//| return 0;\n", {"x.h:1: ", "no region is open"}},
        {"//[ task 1.1\n//| 0;\na;\n//]\n", {"x.h:3: ", "behind the stub of task 1.1"}},
        {"//[ tsak 1.1\n//]\n", {"x.h:1: ", "expected //[ task 2.3", "//[ tsak 1.1"}},
        {"//[ task one\n//]\n", {"x.h:1: ", "//[ task one"}},
        {"//[ task 1.1\n//] end\n", {"x.h:2: ", "alone on its line"}},
    };
    for (const auto& wrong : cases)
        expect_error([&] { parse_markers(wrong.text, "x.h"); }, wrong.words);
}

TEST_F(StubTree, AWrongSheetIsRefusedWithItsPlace) {
    const struct {
        std::string from, to;
        std::vector<std::string> words;
    } cases[] = {
        {"\"points\": 3",
         "\"pionts\": 3",
         {"labs/07_tiny/lab.json:5:", "pionts", "did you mean \"points\"?"}},
        {"\"files\": [\"a.cpp\"]",
         "\"files\": [\"b.cpp\"]",
         {"labs/07_tiny/lab.json:5:", "/tasks/0/files/0", "there is no file", "b.cpp"}},
        {"\"files\": [\"a.cpp\"]", "\"files\": []", {"lab.json:5:", "task 7.1 has no file"}},
        {"\"files\": [\"a.cpp\"]", "\"files\": [\"../../etc\"]", {"lab.json:5:", "leads out"}},
        {"[\"Task7_1.*\"]", "[]", {"lab.json:6:", "/tasks/0/tests", "task 7.1 has no tests"}},
        {", \"tests\": \"lab07_test\"", "", {"lab.json:1:", "\"tests\""}},
        {"\"id\": \"7.2\"", "\"id\": \"7.3\"", {"lab.json:7:", "expected \"7.2\""}},
        {"\"needs\": [\"7.1\"]", "\"needs\": [\"7.4\"]", {"lab.json:8:", "no other task 7.4"}},
        {"\"points\": 4", "\"points\": 0", {"lab.json:7:", "at least 1"}},
        {"07_tiny", "07_tyni", {"lab.json:2:", "expected \"07_tiny\""}},
        {"\"number\": \"07\"", "\"number\": \"08\"", {"lab.json:2:", "begins with"}},
        {"\"version\": 1", "\"version\": 2", {"lab.json:2:", "/version", "expected 1"}},
        {"tests/a_test.cpp", "tests/none.cpp", {"lab.json:3:", "there is no file"}},
        {"{\"id\": \"7.1\"", "{\"id\": \"7.1\",", {"lab.json:5:"}},
    };
    for (const auto& wrong : cases) {
        write_changed("labs/07_tiny/lab.json", sheet, wrong.from, wrong.to);
        expect_error([&] { find_lab(root, "07"); }, wrong.words);
    }
    write("labs/07_tiny/lab.json", sheet);
    expect_error([&] { read_lab_sheet(root, "08_none"); }, {"labs/08_none/lab.json"});
}

TEST_F(StubTree, MarkersAndSheetMustAgree) {
    const LabSheet lab = read_lab_sheet(root, "07_tiny");
    write_changed("labs/07_tiny/a.cpp", source, "task 7.2", "task 7.4");
    expect_error([&] { read_lab_sources(lab); }, {"labs/07_tiny/a.cpp:7: ", "no task 7.4"});
    write_changed("labs/07_tiny/a.cpp", source, "task 7.2", "task 7.1");
    expect_error([&] { read_lab_sources(lab); }, {"labs/07_tiny/a.cpp:1: ", "7.2 has no marker"});
    write("labs/07_tiny/a.cpp", source);
    write("labs/07_tiny/b.cpp", "//[ task 7.1\n//]\n");
    expect_error([&] { read_lab_sources(lab); }, {"labs/07_tiny/b.cpp:1: ", "does not list b.cpp"});
}

TEST_F(StubTree, TheHandoutHasTheHintsOfEveryTask) {
    write("labs/07_tiny/README.md", "# Tiny\n\n## One\n\nTwo\n");
    expect_error([&] { read_lab_sources(read_lab_sheet(root, "07_tiny")); },
                 {"labs/07_tiny/README.md", "no section \"Two\"", "task 7.2"});
}

TEST_F(StubTree, ALabIsWrittenWithoutVariationsAndUnlistedTests) {
    const LabSources lab = read_lab_sources(read_lab_sheet(root, "07_tiny"));
    const std::filesystem::path copy = root / "copy";
    write_lab(lab, {"7.1", "7.2"}, copy);
    EXPECT_FALSE(std::filesystem::exists(copy / "labs/07_tiny/variations"));
    EXPECT_FALSE(std::filesystem::exists(copy / "labs/07_tiny/tests/secret_test.cpp"));
    EXPECT_TRUE(std::filesystem::exists(copy / "labs/07_tiny/tests/a_test.cpp"));
    const std::string text = read_file((copy / "labs/07_tiny/a.cpp").string());
    EXPECT_EQ(text.find("return 1"), std::string::npos);
    EXPECT_EQ(text.find("return 2"), std::string::npos);
    EXPECT_EQ(text.find("//["), std::string::npos);
    // The copy is a lab of its own, whose sheet can be read again.
    EXPECT_EQ(read_lab_sheet(copy, "07_tiny").task_ids(), (std::vector<std::string>{"7.1", "7.2"}));
    // Written again it is left alone: a build does nothing.
    const auto time = std::filesystem::last_write_time(copy / "labs/07_tiny/a.cpp");
    write_lab(lab, {"7.1", "7.2"}, copy);
    EXPECT_EQ(std::filesystem::last_write_time(copy / "labs/07_tiny/a.cpp"), time);
}

TEST_F(StubTree, LabsAreFoundByNumberOrFolder) {
    for (const std::string name : {"7", "07", "07_tiny"})
        EXPECT_EQ(find_lab(root, name).folder, "07_tiny");
    expect_error([&] { find_lab(root, "08"); }, {"no lab '08'", "07_tiny"});
}

} // namespace

} // namespace raylab
