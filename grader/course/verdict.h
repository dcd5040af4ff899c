// NOT IMPLEMENTED, WAITS, WRONG or PASS: what the tests of a task say about a lab.
//
// Each test runs in a process of its own: one that crashes or never ends takes no other with it,
// and what a stub says belongs to the test that met it. A test with a kernel runs with the CUDA
// threads in both orders, forward and reverse.
#pragma once

#include "grader/course/lab_sheet.h"
#include "grader/course/test_program.h"

#include <string>
#include <vector>

namespace raylab {

// waits: it is written, but its tests met the stub of another task, which it needs.
enum class TaskVerdict { not_implemented, waits, wrong, pass };

// "task 2.3 trace_kernel() is not implemented: labs/02_iterative/renderer.cu:41"
struct Stub {
    std::string task, function, place;
    std::string sentence() const;
    bool operator==(const Stub&) const = default;
};

struct TaskResult {
    Task task;
    TaskVerdict verdict = TaskVerdict::pass;
    std::vector<Stub> stubs;        // not_implemented: of this task; waits: of those that it needs
    std::vector<std::string> facts; // what was measured to be wrong, where no stub was met
    std::vector<std::string> said;  // what the lab's own printf() printed in these tests (said.h)
    int tests = 0, passed = 0;
    double seconds = 0;

    int points() const { return verdict == TaskVerdict::pass ? task.points : 0; }

    // What stands before the sentence of one of its stubs.
    std::string before(const Stub& stub) const;
};

// Runs the tests of a task, all from `program`, whose sources are in sheet.root (or a copy of the
// lab, for which the place of a stub is told all the same). A test passes if it ran to its end and
// says so itself. Throws std::runtime_error where a test did not run, which tells nothing about the
// lab: no program, no test that a filter of the task matches, a program that ends before the test
// begins, a test that skips itself or is disabled, a report that cannot be read, no GPU.
// `patience`: how much longer than usual a test may take, in a build that is slower.
TaskResult judge_task(const LabSheet& sheet, const Task& task, const std::filesystem::path& program,
                      double patience = 1);

// The same, of a program that somebody else runs.
TaskResult judge_task(const LabSheet& sheet, const Task& task, const TestProgram& program,
                      double patience = 1);

// The stubs of a task that still stand in the lab's folder, whether or not anything calls them.
std::vector<Stub> standing_stubs(const LabSheet& sheet, const std::filesystem::path& lab_folder,
                                 const Task& task);

const char* name(TaskVerdict verdict); // "NOT IMPLEMENTED", "WAITS", "WRONG", "PASS"

} // namespace raylab
