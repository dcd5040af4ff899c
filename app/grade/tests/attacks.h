// Hostile submissions: the solution of lab 02 with a change that cheats, breaks or breaks out, and
// what the grader must say of it.
#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace raylab {

struct Attack {
    std::string name;
    std::string row;  // the table of docs/grading.md
    std::string file; // of the lab
    std::string find, replace;
    std::vector<std::string> verdicts; // one of them is that of the first task
    int most_points = 0;
    bool always = false; // also in a short test
};

// How GoogleTest prints it.
inline void PrintTo(const Attack& attack, std::ostream* out) { *out << attack.name; }

const std::vector<Attack>& attacks();

} // namespace raylab
