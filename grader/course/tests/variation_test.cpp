// Changes of a solution as they are read and applied.
#include "grader/course/tests/temporary_tree.h"
#include "grader/course/variation.h"

namespace raylab {

namespace {

class Variations : public TemporaryTree {
  protected:
    void mistake(const std::string& members) const {
        write("labs/07_tiny/mistakes/m.json", "{\"title\": \"t\", \"file\": \"a.cpp\", " + members +
                                                  ", \"find\": [\"    return 2;\"], "
                                                  "\"replace\": [\"    return 3;\"]}");
    }
    void expect_error(const std::string& words) const {
        try {
            read_mistakes(read_lab_sheet(root, "07_tiny"));
            ADD_FAILURE() << "read, without a word of: " << words;
        } catch (const CourseError& error) {
            EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
        }
    }
};

TEST_F(Variations, AMistakeIsReadAndApplied) {
    mistake(R"("task": "7.2", "cause": ["one too MANY", "three"])");
    const std::vector<Mistake> all = read_mistakes(read_lab_sheet(root, "07_tiny"));
    ASSERT_EQ(all.size(), 1u);
    EXPECT_EQ(all[0].change.name, "m");
    EXPECT_EQ(all[0].task, "7.2");
    EXPECT_NE(all[0].change.apply(source).find("return 3;"), std::string::npos);
    EXPECT_TRUE(all[0].is_named_by("it is 3: One too many"));
    EXPECT_TRUE(all[0].is_named_by("it should be 2 but is three"));
    EXPECT_FALSE(all[0].is_named_by("one too few"));
}

TEST_F(Variations, WhatIsWrongWithAMistakeIsSaid) {
    mistake(R"("task": "7.9", "cause": ["x"])");
    expect_error("has no task '7.9'");
    mistake(R"("task": "7.2", "causes": ["x"])");
    expect_error("causes");
}

TEST_F(Variations, WhatIsThereTwiceOrNotAtAllIsNotReplaced) {
    Variation change;
    change.find = "a\n", change.replace = "b\n";
    EXPECT_EQ(change.apply("x\na\ny\n"), "x\nb\ny\n");
    EXPECT_EQ(change.apply("xa\na\n"), "xa\nb\n"); // whole lines
    EXPECT_THROW(change.apply("x\n"), CourseError);
    EXPECT_THROW(change.apply("a\na\n"), CourseError);
}

} // namespace

} // namespace raylab
