// The tests of a task, run in the sandbox with the submission linked in.
#pragma once

#include "grader/course/test_program.h"
#include "grader/sandbox/sandbox.h"

#include <optional>

namespace raylab::grading {

// Which tests there are, says the students' tree (`base`); whether they pass, the witness
// (grader/witness).
class SubmittedTests final : public TestProgram {
  public:
    SubmittedTests(const std::filesystem::path& base, std::filesystem::path program,
                   const sandbox::Isolation& isolation)
        : base_(base, "/"), program_(std::move(program)), isolation_(isolation) {}

    std::vector<std::string> tests(const std::string& filter) const override {
        return base_.tests(filter);
    }
    // Throws std::runtime_error for the sandbox's own trouble. After a test that did not end in its
    // time the others are not started, until forget().
    TestRun run(const std::string& name, const std::string& order,
                double limit_seconds) const override;
    bool trusted() const override { return false; }
    bool passed() const override { return passed_; }

    // How a test has ended since the last forget(), if any has not ended by itself; and whether one
    // ended without its record, though it said that all was well.
    std::optional<sandbox::End> bad_end() const { return bad_end_; }
    bool forged() const { return forged_; }
    void forget() const { bad_end_.reset(), forged_ = false; }

  private:
    OwnTestProgram base_;
    std::filesystem::path program_;
    const sandbox::Isolation& isolation_;
    mutable bool passed_ = false, forged_ = false;
    mutable std::optional<sandbox::End> bad_end_;
};

} // namespace raylab::grading
