// Grades one submission: builds it, runs it, judges what it drew. Three stages in three kinds of
// processes: the first two in the sandbox, the last one here, where no line of the submission runs.
#pragma once

#include "grader/course/lab_sheet.h"
#include "grader/grading/picture.h"
#include "grader/results/marks.h"

#include <functional>

namespace raylab::grading {

struct GradeOptions {
    LabSheet sheet;                   // of the tree with the solutions
    std::filesystem::path submission; // a folder, an archive or a file
    std::filesystem::path cache;      // for the base builds of all labs
    std::filesystem::path key;        // file of the grader's key
    std::filesystem::path draw;       // raylab-draw with the solutions
    sandbox::Isolation isolation;
};

// A picture as it was judged, for a report.
struct JudgedPicture {
    GradedPicture picture;
    bool hidden = false;
    bool drawn = false; // false: a task that it needs is not done
    PictureResult result;
};

struct Graded {
    Marks marks;
    std::vector<JudgedPicture> pictures;
};

// `so_far` is called after each step with the marks until then. Throws SubmissionError or
// CourseError for what there is no grading of, any other std::exception for the grader's own
// trouble.
Graded grade(const GradeOptions& options, const std::function<void(const Graded&)>& so_far);

} // namespace raylab::grading
