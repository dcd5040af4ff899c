// Item analysis: which task a class has found hard, and why.
#pragma once

#include "grader/class/journal.h"
#include "grader/course/lab_sheet.h"

#include <map>

namespace raylab {

struct TaskFigures {
    std::string id, title;
    int of_points = 0;
    int graded = 0, passed = 0; // submissions; what the grader had trouble with is in neither
    std::map<MarkVerdict, int> verdicts;
    std::string cause; // that most of those name that do not pass; empty: none is named
    int named = 0;     // how many name it

    double passed_share() const { return graded ? double(passed) / graded : 0; }
};

struct ClassFigures {
    std::vector<TaskFigures> tasks;
    std::vector<int> scores; // of all that were graded, and of refused ones 0; ascending
    int submissions = 0, waiting = 0, refused = 0, internal = 0, late = 0;
    std::optional<double> median_tries; // of those where the platform tells them

    double median_score() const;
};

ClassFigures figures_of(const Journal& journal, const LabSheet& sheet);

} // namespace raylab
