// The tree that students of one lab get: it builds, checks and renders by itself, and has no line
// of a solution.
//
// One tree a lab: what lab 02 stands on, in common, answers the tasks of lab 01. Files of common
// that answer a task of the lab are on its sheet's `withhold` list. One that has regions `//[
// withhold 01` goes out with those regions' stubs in their place, one that has none stays behind.
// Files that a later lab withholds are withheld here, too: students of lab 02 write lab 03 later.
#pragma once

#include "grader/course/stub_tree.h"

namespace raylab {

struct ReleasedTree {
    // Squeezed: of the tasks of this lab and of all later ones, and of what was withheld.
    std::set<std::string> solution_lines;
    int files = 0;
};

// Writes the tree for the lab into an empty folder. Throws CourseError if the `withhold` list and
// the regions of common do not agree.
ReleasedTree write_student_tree(const LabSources& lab, const std::filesystem::path& target);

// A line of code without its comment and all white space; "" if it is too short to give anything
// away, or only names a field or the result of a call.
std::string squeezed(const std::string& line);

// The lines of a region's solution that give something away, squeezed: those not in its stub.
std::vector<std::string> telling_lines(const MarkedRegion& region);

// Calls back with each line of the text files below a folder: the file relative to it, the line's
// number from 1, and the line.
void for_each_line(
    const std::filesystem::path& folder,
    const std::function<void(const std::string&, int, const std::string&)>& with_line);

// "file:line: the solution's line" for each line of a solution in a file of the tree.
std::vector<std::string> leaks(const std::filesystem::path& tree,
                               const std::set<std::string>& solution_lines);

} // namespace raylab
