// The submissions of a class, as a platform exports them:
//
//     Gradescope     submission_metadata.yml, submission_123/...
//     Moodle         Ada Lovelace_123_assignsubmission_file/..., or ..._file_path.h without folders
//     Canvas         lovelaceada_123_456_path.h, lovelaceada_LATE_123_456_work.zip
//     Classroom 50   scores.csv, CLASSROOM-ASSIGNMENT-LOGIN/...
//     any other      a folder or an archive a student
//
// Each may stand in a folder of its own, and be a folder or an archive.
#pragma once

#include "grader/course/lab_sheet.h"
#include "grader/submissions/item.h"

namespace raylab {

struct Student {
    std::string id, name, email; // id: what the platform knows the student by
};

struct ClassEntry {
    std::string id;                // fit for the name of a folder; no other entry has it
    std::vector<Student> students; // several: they work in a group
    bool late = false;             // the platform says so
    int tries = 0;                 // how often something was sent; 0: the platform does not say
    std::vector<Item> items;       // named as the student named them
};

struct ClassExport {
    std::string layout; // "Moodle", ...; "a folder or an archive a student"
    std::vector<ClassEntry> entries;
    std::vector<std::string> unused; // files that are nobody's
};

// Reads the folder or the archive `submissions`; of an archive what may be of use goes to files
// below `scratch`, which the items then name. Throws SubmissionError.
ClassExport read_class(const std::filesystem::path& submissions, const LabSheet& sheet,
                       const std::filesystem::path& scratch);

// Who has sent what. `metadata` is the text of Gradescope's file; `packed`: the items come from an
// archive, where a folder around all of them is not a student's.
ClassExport group_class(std::vector<Item> items, const std::string& metadata, bool packed);

} // namespace raylab
