// class.html: one file, for the eyes of the people who teach.
#pragma once

#include "grader/class/journal.h"
#include "grader/course/lab_sheet.h"

namespace raylab {

// A table of all submissions to filter and sort, and above it the item analysis. Links lead to
// reports in `folder`, where they are. Works without the network and under the policy of
// html_page().
std::string class_page(const Journal& journal, const LabSheet& sheet,
                       const std::filesystem::path& folder);

} // namespace raylab
