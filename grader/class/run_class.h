// Grades what waits, several submissions at a time, each by a program of its own.
#pragma once

#include "grader/class/journal.h"

#include <atomic>

namespace raylab {

struct ClassGrader {
    // Called with "LAB FOLDER -o DIR" behind it; ends with 0 or 1 and leaves DIR/marks.json, or
    // ends with anything else: the grader's own trouble.
    std::vector<std::string> program;
    std::string lab;
    std::filesystem::path folder; // of the class
    int jobs = 1;
    double limit_seconds = 1800; // for one submission
};

// Where a class keeps what belongs to a submission.
std::filesystem::path files_of(const std::filesystem::path& folder, const std::string& hash);
std::filesystem::path run_of(const std::filesystem::path& folder, const std::string& run);

// Until nothing waits. `after_each` is told how many are done, and may be called by several
// threads. Throws FileError if the journal cannot be written: then the others are finished first.
void run_class(Journal& journal, Set set, const ClassGrader& grader,
               const std::function<void(int done)>& after_each);

// Removes runs and files that no submission refers to: what killed programs and regrades left.
void tidy(const Journal& journal, const std::filesystem::path& folder);

} // namespace raylab
