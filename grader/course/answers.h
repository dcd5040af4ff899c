// Which tasks of other labs a released tree answers. Lab 03 stands on what labs 01 and 02 teach, so
// its tree has that in `common`: who is yet to write lab 01 must not see it.
#pragma once

#include "grader/course/stub_tree.h"

#include <map>

namespace raylab {

// Each line of the solutions of a lab's tasks that gives something away, squeezed (release.h), and
// the tasks that it is of.
using SolutionLines = std::map<std::string, std::set<std::string>>;
SolutionLines solution_lines(const LabSources& lab);

struct Answer {
    std::string task;
    std::set<std::string> files; // of the tree: those that answer it as a whole by the lab's sheet,
                                 // and those with lines of its solution
    int lines = 0, of_lines = 0; // of its solution that stand in the tree
};

// Of all labs before `sheet`'s, in the order of the tasks; nothing for a task that the tree does
// not answer. `tree` is what write_student_tree() has written for `sheet`. Throws CourseError.
std::vector<Answer> earlier_answers(const LabSheet& sheet, const std::filesystem::path& tree);

// For people: one line a task.
std::string to_text(const std::vector<Answer>& answers);

} // namespace raylab
