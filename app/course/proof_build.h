// The build folder in which `raylab prove` tests the tests.
//
// All states of a lab are built one after the other in it, from a folder laid over the tree
// (RAYLAB_OVERLAY): only what a state changes is compiled again.
#pragma once

#include "app/course/check_run.h"
#include "grader/course/stub_tree.h"
#include "grader/course/variation.h"

#include <set>

namespace raylab::app {

class ProofBuild {
  public:
    // Throws CourseError, std::runtime_error.
    explicit ProofBuild(const Tree& tree);

    // Checks tasks of the lab, by default all, with some of them stubbed and a change of its
    // solution, or none.
    CheckReport check(const LabSources& lab, const std::set<std::string>& stubbed,
                      const Variation* change, const std::vector<std::string>& tasks = {});

  private:
    std::filesystem::path overlay_;
    Tree proof_tree_;
};

} // namespace raylab::app
