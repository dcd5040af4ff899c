// What `check` has found, as marks (grader/results).
#pragma once

#include "app/course/check_run.h"
#include "grader/results/marks.h"

namespace raylab::app {

// Of the tasks that were asked for; those without a result yet are NOT_RUN, or COMPILE_ERROR.
Marks marks_of(const CheckReport& report, const std::vector<std::string>& ids);

// Where nothing can be said, and why.
Marks no_marks(const LabSheet& sheet, const std::vector<std::string>& ids,
               const std::string& trouble);

} // namespace raylab::app
