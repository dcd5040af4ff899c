// What a student has written survives an update, and everything else is the mended release's.
#include "grader/course/update_tree.h"

#include "common/cli/files.h"

#include <gtest/gtest.h>

#include <map>
#include <optional>

namespace raylab {

namespace {

namespace fs = std::filesystem;

class Update : public testing::Test {
  protected:
    void SetUp() override {
        std::string pattern = (fs::temp_directory_path() / "raylab-update-XXXXXX").string();
        root = mkdtemp(pattern.data());
        for (const char* tree : {"base", "mended", "own"}) fs::create_directories(root / tree);
    }
    void TearDown() override { fs::remove_all(root); }

    // The file in the three trees; "" where it is missing.
    void write(const std::string& file, const std::string& base, const std::string& mended,
               const std::string& own) const {
        for (const auto& [tree, text] :
             {std::pair{"base", base}, std::pair{"mended", mended}, std::pair{"own", own}}) {
            if (text.empty()) continue;
            fs::create_directories((root / tree / file).parent_path());
            write_file((root / tree / file).string(), text);
        }
    }
    std::map<std::string, std::string> update(const std::set<std::string>& task_files = {}) const {
        const auto updates = plan_update(root / "base", root / "mended", root / "own", task_files);
        apply_update(updates, root / "mended", root / "own");
        std::map<std::string, std::string> fates;
        for (const FileUpdate& file : updates) fates[file.file] = name(file.fate);
        return fates;
    }
    std::string own(const std::string& file) const {
        const fs::path path = root / "own" / file;
        return fs::exists(path) ? read_file(path.string()) : "";
    }

    fs::path root;
};

using Fates = std::map<std::string, std::string>;

TEST_F(Update, WhatNobodyTouchedIsTheMendedReleases) {
    write("common/a.h", "old\n", "new\n", "old\n");
    write("common/gone.h", "old\n", "", "old\n");
    write("common/added.h", "", "new\n", "");
    write("common/same.h", "old\n", "old\n", "old\n");
    EXPECT_EQ(update(), (Fates{{"common/a.h", "replaced"},
                               {"common/added.h", "added"},
                               {"common/gone.h", "removed"}}));
    EXPECT_EQ(own("common/a.h"), "new\n");
    EXPECT_EQ(own("common/added.h"), "new\n");
    EXPECT_EQ(own("common/gone.h"), "");
}

TEST_F(Update, WhatAStudentHasWrittenStays) {
    write("notes.md", "", "", "own\n");
    write("labs/02/path.h", "stub\n", "stub\n", "own\n");
    write("gone.h", "old\n", "", "own\n");
    write("deleted.h", "old\n", "old\n", "");
    EXPECT_EQ(update(), Fates{});
    EXPECT_EQ(own("notes.md") + own("labs/02/path.h") + own("gone.h"), "own\nown\nown\n");
    EXPECT_EQ(own("deleted.h"), "");
}

TEST_F(Update, ChangesOfBothAreMergedWhereTheyDoNotTouch) {
    const std::string text = "1\n2\n3\n4\n5\n6\n7\n8\n";
    write("a.h", text, "one\n" + text.substr(2), text.substr(0, 14) + "eight\n");
    EXPECT_EQ(update(), (Fates{{"a.h", "merged"}}));
    EXPECT_EQ(own("a.h"), "one\n2\n3\n4\n5\n6\n7\neight\n");
    EXPECT_EQ(own("a.h.new"), "");
}

TEST_F(Update, WhereTheyTouchTheStudentsFileStaysAndTheMendedOneLiesBesideIt) {
    write("a.h", "1\n", "one\n", "own\n");
    EXPECT_EQ(update(), (Fates{{"a.h", "kept"}}));
    EXPECT_EQ(own("a.h"), "own\n");
    EXPECT_EQ(own("a.h.new"), "one\n");
}

TEST_F(Update, AFileWithTasksIsNeverMerged) {
    const std::string text = "1\n2\n3\n4\n5\n6\n7\n8\n";
    const std::string written = text.substr(0, 14) + "eight\n";
    write("labs/02/path.h", text, "one\n" + text.substr(2), written);
    EXPECT_EQ(update({"labs/02/path.h"}), (Fates{{"labs/02/path.h", "kept"}}));
    EXPECT_EQ(own("labs/02/path.h"), written);
    EXPECT_EQ(own("labs/02/path.h.new"), "one\n" + text.substr(2));
}

TEST_F(Update, DoneAgainItDoesTheRest) {
    write("a.h", "old\n", "new\n", "old\n");
    write("b.h", "old\n", "new\n", "new\n"); // an interrupted update was here
    EXPECT_EQ(update(), (Fates{{"a.h", "replaced"}}));
    EXPECT_EQ(update(), Fates{});
}

} // namespace

} // namespace raylab
