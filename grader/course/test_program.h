// The program with the tests of a lab's tasks, and what one run of it leaves.
#pragma once

#include "common/cli/process.h"

namespace raylab {

struct TestRun {
    ProcessResult process;
    bool began = false;           // "[ RUN ]" was printed
    std::string report, findings; // GoogleTest's JSON; of the CPU machine (RAYLAB_FINDINGS)
};

class TestProgram {
  public:
    virtual ~TestProgram() = default;

    // The names of the tests that a filter matches. Throws std::runtime_error.
    virtual std::vector<std::string> tests(const std::string& filter) const = 0;

    // Runs one test, with the CUDA threads in this order (RAYLAB_ORDER). An untrusted program may
    // not be started any more (ProcessResult::started).
    virtual TestRun run(const std::string& name, const std::string& order,
                        double limit_seconds) const = 0;

    // Whether what it says of itself is believed. A submission's word is not: the words of TestRun
    // are for people, and passed() decides.
    virtual bool trusted() const { return true; }

    // Whether the last run of an untrusted program has passed, by the word of somebody else.
    virtual bool passed() const { return true; }
};

// The program of somebody who tests his own lab: run as it is.
class OwnTestProgram final : public TestProgram {
  public:
    OwnTestProgram(std::filesystem::path program, std::filesystem::path folder)
        : program_(std::move(program)), folder_(std::move(folder)) {}
    std::vector<std::string> tests(const std::string& filter) const override;
    TestRun run(const std::string& name, const std::string& order,
                double limit_seconds) const override;

  private:
    std::filesystem::path program_, folder_;
};

} // namespace raylab
