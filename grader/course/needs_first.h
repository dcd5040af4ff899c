// Which of several wrong tasks is to be mended first.
#pragma once

#include "grader/course/verdict.h"

#include <vector>

namespace raylab {

// A task that builds on a wrong one may be right itself: its facts would lead astray. So the first
// fact of a WRONG task names each WRONG task that it needs. Of two tasks that need each other, the
// first in the list is mended first.
void say_what_is_needed_first(std::vector<TaskResult>& results);

} // namespace raylab
