// From what a platform exports to the journal of a class.
#pragma once

#include "grader/class/journal.h"
#include "grader/course/lab_sheet.h"

namespace raylab::app {

struct EnteredClass {
    int submissions = 0;
    std::string layout;              // as which platform exports
    std::vector<std::string> unused; // files that are nobody's, the first few
};

// Unpacks every submission into `folder` and enters it; one that is refused is entered with the
// reason, and takes no other with it. Throws SubmissionError for the export as a whole.
EnteredClass enter_class(const std::filesystem::path& submissions, const LabSheet& sheet,
                         const std::filesystem::path& folder, Journal& journal);

} // namespace raylab::app
