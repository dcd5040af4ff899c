// The known mistakes of students (labs/NN_name/mistakes): each must make its task WRONG, and the
// first thing that `check` says of the task must name the cause.
#pragma once

#include "app/course/proof_build.h"

namespace raylab::app {

struct MistakeProof {
    std::string lab;
    Mistake mistake;
    bool killed = false, named = false;
    std::string said;                // the first fact of the task
    std::vector<std::string> others; // tasks that are WRONG, too
    double seconds = 0;
};

// Those of a lab whose name has `only` in it; prints a line each. Throws CourseError.
std::vector<MistakeProof> prove_mistakes(ProofBuild& build, const LabSheet& sheet,
                                         const std::string& only);

std::string to_markdown(const std::vector<MistakeProof>& proofs);

// Prints the sums. Failed if a mistake passes, or fewer than nine in ten are called by their cause.
ExitCode judged(const std::vector<MistakeProof>& proofs);

} // namespace raylab::app
