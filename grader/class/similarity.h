// What the students of a class wrote themselves, for JPlag and Dolos: a folder a submission, in it
// the lab's files without the lines that every student was given.
#pragma once

#include "grader/class/journal.h"
#include "grader/course/stub_tree.h"

namespace raylab {

// The lines of `text` that are not in `given`, in their order: those outside a longest common
// subsequence of lines, where spaces at the ends of a line do not count.
std::string own_lines(const std::string& text, const std::string& given);

// Writes target/ID/FILE for each submission that has files; FILE of CUDA ends in ".cu.cpp", since
// both programs know languages by their endings. Returns how many. Throws FileError if `target` is
// not empty.
int export_own_lines(const Journal& journal, const LabSources& lab,
                     const std::filesystem::path& folder, const std::filesystem::path& target);

} // namespace raylab
