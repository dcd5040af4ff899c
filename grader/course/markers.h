// Solution and stub are one source: a task's body stands between two markers, the stub's beside it.
//
//     //[ task 2.3
//     the solution                    shown to the compiler as the file stands
//     //| the stub, behind bars       what a student gets in its place
//     //]
//
// A region `//[ withhold 01` in a file of common answers a task of lab 01: in what lab 01's
// students get, the lines behind bars stand in its place, if there are any.
#pragma once

#include "grader/course/course_error.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace raylab {

struct MarkedRegion {
    enum class Kind { task, withhold };
    Kind kind;
    std::string id; // of the task, or number of the lab
    int line;       // of the opening marker, from 1
    std::vector<std::string> solution, stub;
};

// A source as it is: plain lines and regions in turn.
struct MarkedSource {
    struct Piece {
        std::vector<std::string> lines;   // plain, before the region
        std::vector<MarkedRegion> region; // none behind the last lines, else one
    };
    std::string file;
    std::vector<Piece> pieces;

    std::vector<const MarkedRegion*> regions() const;
};

// Throws CourseError `file:line: ...` if a marker is unbalanced, nested or misspelled, if a bar
// stands outside, or a solution behind the stub.
MarkedSource parse_markers(std::string_view text, const std::string& file);

// The source for a student: no markers; where `stubbed` says so the stub, elsewhere the solution.
// A withheld region without a stub leaves nothing.
std::string student_source(const MarkedSource& source,
                           const std::function<bool(const MarkedRegion&)>& stubbed);

} // namespace raylab
