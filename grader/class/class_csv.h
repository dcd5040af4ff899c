// marks.csv: a row a student, for the platform's own gradebook.
#pragma once

#include "grader/class/journal.h"
#include "grader/course/lab_sheet.h"

namespace raylab {

// Score and maximum are two numbers, never a share; the score is empty where there are no marks. As
// RFC 4180 wants it, and without formulas (csv_field()).
std::string class_csv(const Journal& journal, const LabSheet& sheet);

} // namespace raylab
