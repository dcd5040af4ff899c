// labs/NN_name/lab.json: what a lab asks of its students.
//
//     { "version": 1, "number": "02", "folder": "02_iterative", "title": "...",
//       "tests": "lab02_tasks_test",
//       "test_files": ["tests/loop_test.cpp", ...],
//       "scenes": ["cornell", ...],
//       "withhold": { "common/trace/intersect.h": ["1.2"], ... },
//       "tasks": [ { "id": "2.1", "title": "...", "points": 30, "minutes": 90,
//                    "files": ["path.h"], "tests": ["Task2_1.*"], "needs": [],
//                    "hints": "2.1 The loop", "picture": "what you should see" }, ... ],
//       "graded_pictures": [ { "scene": "cornell", "roulette": false,
//                              "options": ["--block", "64"], "tasks": ["2.1", "2.2"], "counts":
//                              ["2.6"] }, ... ] }
#pragma once

#include "grader/course/course_error.h"

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace raylab {

struct Task {
    std::string id; // "2.1": the lab's number, a dot, 1 2 3 ... in the order of the list
    std::string title;
    int points = 0;
    int minutes = 0;                // a student is expected to need
    std::vector<std::string> files; // in the lab's folder: where its markers are
    std::vector<std::string> tests; // GoogleTest filters: "Task2_1.*"
    std::vector<std::string> needs; // tasks without which its tests cannot tell
    std::string hints;              // heading of its section in the lab's README.md
    std::string picture;            // what should be seen when it is done
};

// A file of common, by its place in the tree, that answers tasks of a lab: left out of its release,
// or in part (markers.h, `withhold`).
struct Withheld {
    std::string file;
    std::set<std::string> answers; // ids of the lab's tasks
};

// A picture that `grade` draws: it is right only if each of its tasks is.
struct GradedPicture {
    std::string scene;                // of the bundled ones
    bool roulette = true;             // false: switched off in the scene
    std::vector<std::string> options; // of `raylab render`; they change no bit
    std::vector<std::string> tasks;
    std::vector<std::string> counts; // tasks that are right only if the ledger's counts are, too
};

struct LabSheet {
    std::filesystem::path root; // of the tree that the lab is in
    std::string number;         // "02"
    std::string folder;         // "02_iterative"
    std::string title;
    std::string test_target;             // the program that has the tests of all tasks
    std::vector<std::string> test_files; // its sources, handed out with the lab
    std::vector<std::string> scenes;     // worth rendering with it
    std::vector<Withheld> withhold;
    std::vector<Task> tasks;
    std::vector<GradedPicture> pictures;

    std::filesystem::path path() const { return root / "labs" / folder; }
    const Task* find(const std::string& id) const; // nullptr if there is no such task
    std::vector<std::string> task_ids() const;
    std::vector<std::string> files() const; // of all tasks, each once
};

// Reads and checks root/labs/FOLDER/lab.json: keys, types, ids, that every file named is there and
// every task has tests. Throws CourseError `labs/02_iterative/lab.json:line:column: ...`.
LabSheet read_lab_sheet(const std::filesystem::path& root, const std::string& folder);

// The folders of the tree's labs, those with a lab.json, in order: "01_recursive", ...
std::vector<std::string> lab_folders(const std::filesystem::path& root);

// The sheet of one lab, by number ("02", "2") or folder. Throws CourseError with the labs there
// are.
LabSheet find_lab(const std::filesystem::path& root, const std::string& name);

} // namespace raylab
