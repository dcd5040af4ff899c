// A tree with one small lab in a temporary folder, in which one part can be made wrong.
#pragma once

#include "grader/course/stub_tree.h"

#include <gtest/gtest.h>

#include <fstream>

namespace raylab {

class TemporaryTree : public testing::Test {
  protected:
    void SetUp() override {
        std::string pattern =
            (std::filesystem::temp_directory_path() / "raylab-course-XXXXXX").string();
        root = mkdtemp(pattern.data());
        write("labs/07_tiny/a.cpp", source);
        write("labs/07_tiny/tests/a_test.cpp", "// public\n");
        write("labs/07_tiny/tests/secret_test.cpp", "// not listed\n");
        write("labs/07_tiny/variations/v.json", "{}\n");
        write("labs/07_tiny/README.md", "# Tiny\n\n## One\n\n## Two\n");
        write("labs/07_tiny/lab.json", sheet);
    }
    void TearDown() override { std::filesystem::remove_all(root); }

    void write(const std::string& name, const std::string& text) const {
        std::filesystem::create_directories((root / name).parent_path());
        std::ofstream(root / name) << text;
    }

    // The file with the first `from` replaced by `to`.
    void write_changed(const std::string& name, std::string text, const std::string& from,
                       const std::string& to) const {
        const std::size_t at = text.find(from);
        ASSERT_NE(at, std::string::npos) << from;
        write(name, text.replace(at, from.size(), to));
    }

    std::filesystem::path root;

    const std::string source = "int before();\n"
                               "//[ task 7.1\n"
                               "int one() { return 1; }\n"
                               "//| int one() { not_implemented(\"7.1\", \"one()\"); return 0; }\n"
                               "//]\n"
                               "int f() {\n"
                               "    //[ task 7.2\n"
                               "    return 2;\n"
                               "    //| not_implemented(\"7.2\", \"f()\");\n"
                               "    //|\n"
                               "    //|   return 0;\n"
                               "    //]\n"
                               "}\n";
    const std::string sheet = R"({
    "version": 1, "number": "07", "folder": "07_tiny", "title": "tiny", "tests": "lab07_test",
    "test_files": ["tests/a_test.cpp"],
    "tasks": [
        {"id": "7.1", "title": "one", "points": 3, "minutes": 5, "files": ["a.cpp"],
         "tests": ["Task7_1.*"], "hints": "One", "picture": "black"},
        {"id": "7.2", "title": "two", "points": 4, "minutes": 5, "files": ["a.cpp"],
         "tests": ["Task7_2.*"], "needs": ["7.1"], "hints": "Two", "picture": "white"}
    ]
})";
};

} // namespace raylab
