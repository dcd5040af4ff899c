// What `raylab check` does once its arguments are read.
#pragma once

#include "common/cli/exit_codes.h"
#include "grader/course/verdict.h"

#include <functional>
#include <optional>

namespace raylab::app {

// Where the program's own tree and build are.
struct Tree {
    std::filesystem::path root, build;
};

struct CheckReport {
    LabSheet sheet;
    std::string compiler_errors;     // not empty: the lab does not compile, and no task was judged
    std::vector<TaskResult> results; // of the tasks that were asked for
    double build_seconds = 0, test_seconds = 0;

    bool passed() const;
};

// Builds the lab's tests and judges the tasks with these ids. Throws CourseError for what is wrong
// with the lab's sheet, std::runtime_error if the build itself cannot be run. `after_task` gets
// what is known after each task.
CheckReport check_tasks(const Tree& tree, const LabSheet& sheet,
                        const std::vector<std::string>& ids, double patience = 1,
                        const std::function<void(const CheckReport&)>& after_task = {});

// For people: one line a task, facts beneath.
std::string to_text(const CheckReport& report);

// For programs: the same as one JSON object.
std::string to_json(const CheckReport& report);

} // namespace raylab::app
