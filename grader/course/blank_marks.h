// Marks of a lab before anything is known of a submission.
#pragma once

#include "grader/course/lab_sheet.h"
#include "grader/results/marks.h"

namespace raylab {

// One mark for each of the tasks with these ids, NOT_RUN, with what the lab's sheet says of the
// task. `grader` is the program that will say more.
Marks blank_marks(const LabSheet& sheet, const std::vector<std::string>& ids,
                  const std::string& grader);

} // namespace raylab
