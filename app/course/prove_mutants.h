// Mutants of the solutions (grader/course/mutant.h): on each of them a test must fail, of its own
// task or of another.
#pragma once

#include "app/course/proof_build.h"
#include "grader/course/mutant.h"

namespace raylab::app {

enum class Fate { killed, survives, equivalent, does_not_compile };

// One in `every` of those with `only` in their file or kind.
struct MutantSample {
    std::string only;
    int every = 1;
};

struct MutantProof {
    std::string lab; // its folder
    Mutant mutant;
    Fate fate = Fate::survives;
    std::vector<std::string> killers; // tasks that are WRONG
    double seconds = 0;
    MutantSample sample; // that it is one of
};

// A sample of a lab's mutants; prints a line each. Throws CourseError.
std::vector<MutantProof> prove_mutants(ProofBuild& build, const LabSheet& sheet,
                                       const MutantSample& sample);

std::string to_markdown(const std::vector<MutantProof>& proofs);

// Prints the sums. Failed if a mutant survives.
ExitCode judged(const std::vector<MutantProof>& proofs);

} // namespace raylab::app
