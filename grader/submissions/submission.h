// One submission, ready to be graded: the lab's files and nothing else.
#pragma once

#include "grader/course/lab_sheet.h"
#include "grader/submissions/item.h"
#include "grader/submissions/submission_error.h"

namespace raylab {

struct Submission {
    std::filesystem::path folder;     // `into`; files have their names in the lab's folder
    std::vector<std::string> files;   // "path.h", "kd/split.cpp": of the lab, and sent
    std::vector<std::string> missing; // of the lab, and not sent
    std::vector<std::string> ignored; // sent, and not of the lab
    std::string hash;                 // SHA-256 over the files' names and texts, in hex
};

// Reads a folder, an archive (zip, tar, tar.gz, ...), a folder with an archive in it, or one source
// file; writes the lab's files below `into` (UTF-8, no byte order mark, '\n'), which appears whole
// or not at all and must not be there before. What is in `from` is not changed, and no name of it
// is used but the lab's own. Throws SubmissionError for what is wrong with the submission,
// FileError for the disk's own trouble.
Submission unpack_submission(const std::filesystem::path& from, const LabSheet& sheet,
                             const std::filesystem::path& into, const UnpackLimits& limits = {});

// The same in two steps, of files that were collected already: first the texts, then the folder.
// `who` names the submission in errors; `scratch` is a folder's name that is free for a while.
struct SentFiles {
    Submission submission;          // its folder is empty
    std::vector<std::string> texts; // of submission.files
};
SentFiles read_items(const std::vector<Item>& items, const std::string& who, const LabSheet& sheet,
                     const std::filesystem::path& scratch, const UnpackLimits& limits = {});
Submission write_submission(SentFiles sent, const std::filesystem::path& into);

} // namespace raylab
