// Which of the files that were sent are the lab's: a student sends the files alone, the lab's
// folder, the whole tree, or any of these in a folder with a name of its own.
#pragma once

#include "grader/course/lab_sheet.h"
#include "grader/submissions/item.h"

namespace raylab {

struct Picked {
    struct File {
        std::string file; // in the lab's folder: "kd/split.cpp"
        Item item;
    };
    std::vector<File> files;
    std::vector<std::string> missing; // files of the lab
    std::vector<std::string> ignored; // names of the others, as sent, without junk
};

// Takes all files from the one folder that is most likely the lab's: it is called labs/FOLDER, or
// FOLDER, or else it has the most of the lab's files. Throws SubmissionError if two folders are
// equally likely, and if there is a hostile name. Nothing picked: `files` is empty.
Picked pick_files(const std::vector<Item>& items, const LabSheet& sheet);

// Whether a name could be picked.
bool could_be_of_lab(const std::string& name, const LabSheet& sheet);

} // namespace raylab
