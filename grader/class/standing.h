// What a row of the journal comes to: for the page, the CSV, and people.
#pragma once

#include "grader/class/journal.h"
#include "grader/course/lab_sheet.h"

namespace raylab {

struct Standing {
    std::optional<int> score; // nothing: not graded, or the grader had trouble and no older marks
    MarkVerdict verdict = MarkVerdict::not_run;
    std::string reason; // one sentence, on one line; empty if all is well
};

Standing standing_of(const JournalRow& row);

// The mark of a task in the row's marks; nullptr if it has none.
const Mark* mark_of(const JournalRow& row, const std::string& task);

int points_of(const LabSheet& sheet); // the most that there are

// The likely cause that a reason names, or the whole reason.
std::string cause_in(const std::string& reason);

// The cause with '#' in place of its figures: the same cause reads alike whatever was measured.
std::string without_figures(const std::string& cause);

} // namespace raylab
