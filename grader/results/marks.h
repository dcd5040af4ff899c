// Marks: what a grader says of one submission, before any platform's format. The writers of this
// folder (formats.h) read it and measure nothing.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace raylab {

enum class MarkVerdict {
    not_run, // not yet, or never, since another task came to an end before
    not_implemented,
    compile_error,
    wrong,        // a test of the task fails
    wrong_image,  // a picture that depends on the task differs from the reference
    non_finite,   // the picture has NaN or infinity
    wrong_size,   // the picture has not the size that was asked for
    time_limit,   // the task's program was ended
    memory_limit, // the same
    output_limit, // it wrote more than it may
    crash,        // a signal ended it, or the CPU machine
    no_output,    // it ended without its picture or its record
    suspicious,   // seed ignored, cached, denoised, no launch, a symbol that no task needs
    unsandboxed,  // not run, since this machine cannot keep the program from the references
    internal,     // the grader's own trouble; no mark changes
    pass,
};

const char* name(MarkVerdict verdict); // "NOT_RUN", "NOT_IMPLEMENTED", ...

// All there are, in the order above.
const std::vector<MarkVerdict>& all_verdicts();

// The verdict with this name; nothing if none has it.
std::optional<MarkVerdict> verdict_named(std::string_view name);

// Of one task.
struct Mark {
    std::string id, title; // "2.3", "Progressive accumulation"
    MarkVerdict verdict = MarkVerdict::not_run;
    int of_points = 0;
    std::vector<std::string> reasons; // sentences for the student, the most important first
    std::string file;                 // where it stands, "labs/02_iterative/renderer.cu"; or empty
    int line = 0;                     // 0: not known
    std::string read_on;              // the section of the handout: "2.3 Accumulation"
    double seconds = 0;

    int points() const { return verdict == MarkVerdict::pass ? of_points : 0; }
};

struct Marks {
    std::string lab, title; // "02_iterative", "The iterative kernel"
    std::string grader;     // the program that says this
    std::vector<Mark> tasks;
    std::string sandbox;  // how the submission was kept apart: "tier 1: bubblewrap, cgroup v2"
    std::string compiler; // the compiler's words, if the submission does not compile
    std::string trouble;  // the grader's own: then nothing is said about the submission
    std::string log;      // the last words of its programs, as they came
    std::vector<std::string> missing; // files of the lab that the submission does not have
    std::vector<std::string> ignored; // files of the submission that are none of the lab's
    double seconds = 0;

    int points() const {
        int sum = 0;
        for (const Mark& mark : tasks) sum += mark.points();
        return sum;
    }
    int of_points() const {
        int sum = 0;
        for (const Mark& mark : tasks) sum += mark.of_points;
        return sum;
    }
    bool passed() const {
        return trouble.empty() && !tasks.empty() &&
               std::all_of(tasks.begin(), tasks.end(),
                           [](const Mark& mark) { return mark.verdict == MarkVerdict::pass; });
    }
};

// The reasons and where to read on, as lines of plain text.
std::string explanation(const Mark& mark);

// The first error among the words of a compiler, one line: "labs/02_iterative/path.h:41:7: error:
// ..."; the first line, if none says that it is an error.
std::string first_error(const std::string& compiler);

// How a whole submission is called: INTERNAL if the grader had trouble, PASS if all tasks pass,
// else the gravest verdict of a task.
MarkVerdict overall(const Marks& marks);

// What was graded and how, as lines of plain text: missing and ignored files, the sandbox.
std::string circumstances(const Marks& marks);

} // namespace raylab
