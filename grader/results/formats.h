// Marks in the formats of the platforms that courses use, each in a file of its own. All texts are
// complete files, valid UTF-8 whatever bytes a submission has printed.
#pragma once

#include "grader/results/marks.h"

#include <string>
#include <vector>

namespace raylab {

// /autograder/results/results.json of Gradescope. A task without a verdict is a failed test with a
// reason, so that a file written before the end is worth the marks earned until then.
std::string gradescope(const Marks& marks);

// /grade/results/results.json of PrairieLearn, at most 1 MB. `gradable` is false for the grader's
// own trouble and for what does not compile: neither uses up an attempt.
std::string prairielearn(const Marks& marks);

// What Classroom 50 tells its autograder by the environment.
struct Classroom50 {
    std::string classroom, assignment, submission, commit, release, review, datetime;
    static Classroom50 from_environment(); // datetime: now, in UTC
};
// result.json of Classroom 50, "classroom50/result/v1".
std::string classroom50(const Marks& marks, const Classroom50& about);

// JUnit's XML, which every CI reads: one test case a task.
std::string junit(const Marks& marks);

// Two lines: names of the columns, and score, maximum and verdicts; as RFC 4180 wants it.
std::string csv(const Marks& marks);

// Annotations for GitHub's log: the worst ten, and how many are hidden (a step shows ten).
std::string github_annotations(const Marks& marks);

// Markdown for GITHUB_STEP_SUMMARY, below 1 MiB.
std::string github_summary(const Marks& marks);

// By name, for command lines; "marks" is marks.json (marks_json.h). Throws std::invalid_argument
// with the names there are.
std::string write_marks(const std::string& format, const Marks& marks);
const std::vector<std::string>& mark_formats();

} // namespace raylab
