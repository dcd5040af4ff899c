// The page of one grading: its pictures, with what was judged of them.
#pragma once

#include "grader/grading/grade.h"

namespace raylab::app {

// report.html and results.json in the folder. Hidden scenes are named without their pictures.
// Throws FileError.
void write_grade_report(const grading::Graded& graded, const std::string& folder);

} // namespace raylab::app
