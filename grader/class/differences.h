// What a stage would change.
#pragma once

#include "grader/class/journal.h"

namespace raylab {

struct Difference {
    std::string id, names; // of the submission, and its students'
    std::optional<int> before, after;
    std::vector<std::string> lines; // "2.3: WRONG -> PASS"; "" where the marks are alike
};

// Of all submissions of the stage that were graded and differ. `trouble`: the grader had trouble,
// and applying the stage leaves their marks as they are.
struct Differences {
    std::vector<Difference> changed;
    int same = 0, trouble = 0, waiting = 0;
};
Differences differences_of(const Journal& journal);

std::string to_text(const Differences& differences);

} // namespace raylab
