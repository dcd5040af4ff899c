// A lab as students get it: its folder, with stubs in place of the tasks' solutions.
#pragma once

#include "grader/course/lab_sheet.h"
#include "grader/course/markers.h"

#include <set>

namespace raylab {

struct LabSources {
    LabSheet sheet;
    std::vector<MarkedSource> files; // each by its name in the lab's folder

    const MarkedSource* find(const std::string& file) const; // nullptr if there is none
};

// Reads the lab's sources and holds them against its sheet: every region is of a task that exists
// and that lists the file, every file that a task lists has a region of it, and the handout has the
// section with its hints. Throws CourseError.
LabSources read_lab_sources(const LabSheet& sheet);

// Whether a file, given relative to the lab's folder, is handed out: all but variations, mistakes,
// equivalent mutants and the tests that the sheet does not list.
bool is_handed_out(const LabSheet& sheet, const std::filesystem::path& file);

// Writes what is handed out of the lab below root/labs/FOLDER, the given tasks stubbed. `changes`
// may replace the text of a file. Files that are already there with the same bytes are left alone,
// so that a build does again only what changed.
using ChangeText = std::function<std::string(const std::string& file, std::string text)>;
void write_lab(const LabSources& lab, const std::set<std::string>& stubbed,
               const std::filesystem::path& root, const ChangeText& change = nullptr);

// write_file, except that equal bytes are left alone; makes the folder.
void write_if_changed(const std::filesystem::path& path, const std::string& bytes);

} // namespace raylab
