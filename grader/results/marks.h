// Marks: what a grader says of one submission, before any platform's format. The writers of this
// folder (formats.h) read it and measure nothing.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace raylab {

enum class MarkVerdict {
    not_run, // not yet, or never, since another task came to an end before
    not_implemented,
    compile_error,
    wrong,
    pass,
};

const char* name(MarkVerdict verdict); // "NOT_RUN", "NOT_IMPLEMENTED", ...

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
    std::string grader;     // program and version: who says this
    std::vector<Mark> tasks;
    std::string compiler; // the compiler's words, if the submission does not compile
    std::string trouble;  // the grader's own: then nothing is said about the submission
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

} // namespace raylab
