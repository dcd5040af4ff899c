// Mutants of a lab's solution: one slip of the hand each, in what students write. DeMillo, Lipton
// and Sayward, Hints on Test Data Selection, 1978: tests that fail on each of them leave little
// room.
//
// A mutant that does the same as the solution cannot fail. A person has read it, and says why:
// labs/NN_name/equivalent.json:
//     { "version": 1, "mutants": [ { "file": "path.h", "was": "if (bounce < 1) return true;",
//                                    "is": "if (bounce < 2) return true;", "why": "..." }, ... ] }
#pragma once

#include "grader/course/stub_tree.h"

#include <optional>

namespace raylab {

struct Mutant {
    std::string task, file; // file: in the lab's folder
    int line;               // of the tree's source, from 1
    std::string kind;       // of mutation_kinds()
    std::string was, is;    // the lines that change, each run of white space one space
    std::optional<std::string> why_equivalent;

    std::size_t source, region;            // of LabSources::files, of MarkedSource::regions()
    std::vector<std::string> new_solution; // of this region
};

// All mutants of all task regions, by file and place. Reads equivalent.json, if there is one.
// Throws CourseError if an entry of it fits no mutant.
std::vector<Mutant> mutants_of(const LabSources& lab);

// The lab's sources with this mutant in them.
LabSources planted(const LabSources& lab, const Mutant& mutant);

} // namespace raylab
