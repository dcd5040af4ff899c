// Mutants of the solutions (grader/course/mutant.h): on each of them a test must fail, of its own
// task or of another.
#pragma once

#include "app/course/proof_build.h"
#include "grader/course/mutant.h"

namespace raylab::app {

enum class Fate { killed, survives, equivalent, does_not_compile };

struct MutantProof {
    std::string lab; // its folder
    Mutant mutant;
    Fate fate = Fate::survives;
    std::vector<std::string> killers; // tasks that are WRONG
    double seconds = 0;
    int every = 1; // it is one of a sample, of one mutant in so many
};

// One in `every` mutants of a lab, of those with `only` in their file or kind; prints a line each.
// Throws CourseError.
std::vector<MutantProof> prove_mutants(ProofBuild& build, const LabSheet& sheet,
                                       const std::string& only, int every);

std::string to_markdown(const std::vector<MutantProof>& proofs);

// Prints the sums. Failed if a mutant survives.
ExitCode judged(const std::vector<MutantProof>& proofs);

} // namespace raylab::app
