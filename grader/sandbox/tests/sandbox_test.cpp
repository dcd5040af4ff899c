// Programs that misbehave, in each tier that this machine has. What a tier cannot do it says itself
// (Isolation::missing), and the tests hold it to what it says.
#include "grader/sandbox/sandbox.h"

#include "grader/sandbox/work_folder.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <fstream>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace raylab::sandbox {
namespace {

using testing::HasSubstr;
using testing::Not;

// The tiers that work here, named in the log: a machine without namespaces shows it.
std::vector<Tier> tiers_here() {
    std::vector<Tier> tiers;
    for (const Tier tier : {Tier::isolated, Tier::confined, Tier::limited}) try {
            const Isolation isolation = isolation_of(tier);
            fmt::print("tested: {}\n", isolation.sentence());
            tiers.push_back(tier);
        } catch (const std::runtime_error& error) {
            fmt::print("not tested: {}\n", error.what());
        }
    std::fflush(stdout);
    return tiers;
}

const std::vector<Tier> tiers = tiers_here(); // GoogleTest asks for them more than once

class Sandbox : public testing::TestWithParam<Tier> {
  protected:
    Isolation isolation = isolation_of(GetParam());
    WorkFolder work{isolation, 8 << 20, 100};
    Limits limits{.wall_seconds = 5,
                  .cpu_seconds = 1,
                  .memory = 128 << 20,
                  .file_size = 4 << 20,
                  .output = 256 << 10,
                  .private_files = 8 << 20,
                  .processes = 16};

    Outcome attack(const std::vector<std::string>& words, std::map<int, int> handles = {}) {
        std::vector<std::string> command = {RAYLAB_ATTACKER};
        command.insert(command.end(), words.begin(), words.end());
        return run(command,
                   {.readable = {std::filesystem::path(RAYLAB_ATTACKER)},
                    .writable = {work.path()},
                    .environment = {{"GIVEN", "yes"}},
                    .handles = std::move(handles),
                    .limits = limits},
                   isolation);
    }
    bool closed() const { return isolation.tier != Tier::limited; }
};

INSTANTIATE_TEST_SUITE_P(Tiers, Sandbox, testing::ValuesIn(tiers), [](const auto& tier) {
    return fmt::format("tier{}", static_cast<int>(tier.param));
});

TEST_P(Sandbox, AProgramEndsAsItEnds) {
    EXPECT_TRUE(attack({"exit", "0"}).succeeded());
    const Outcome seven = attack({"exit", "7"});
    EXPECT_EQ(seven.end, End::exited) << seven.trouble << seven.output;
    EXPECT_EQ(seven.exit_code, 7);
    const Outcome crash = attack({"crash"});
    EXPECT_EQ(crash.end, End::crashed);
    EXPECT_EQ(crash.signal, SIGABRT);
}

TEST_P(Sandbox, WhatCannotBeStartedIsTheGradersTrouble) {
    const Outcome outcome = run({"/usr/no/such/program"}, {}, isolation);
    EXPECT_EQ(outcome.end, End::not_started);
    EXPECT_THAT(outcome.trouble, HasSubstr("No such file"));
}

TEST_P(Sandbox, TimeIsLimited) {
    const Outcome loop = attack({"loop"});
    EXPECT_EQ(loop.end, End::time_limit) << why(loop, limits);
    limits.wall_seconds = .3;
    const Outcome sleep = attack({"sleep"});
    EXPECT_EQ(sleep.end, End::time_limit);
    EXPECT_LT(sleep.seconds, 3);
}

TEST_P(Sandbox, MemoryIsLimited) {
    const Outcome outcome = attack({"allocate"});
    if (isolation.memory) {
        EXPECT_EQ(outcome.end, End::memory_limit) << why(outcome, limits) << outcome.output;
        EXPECT_GT(outcome.peak_memory, limits.memory / 2);
        EXPECT_LE(outcome.peak_memory, limits.memory);
    } else {
        EXPECT_THAT(outcome.output, HasSubstr("allocate: Cannot allocate memory"));
    }
}

TEST_P(Sandbox, ProcessesAreLimited) {
    for (const char* bomb : {"fork", "threads"}) {
        const Outcome outcome = attack({bomb});
        EXPECT_THAT(outcome.output, Not(HasSubstr("worked"))) << bomb;
        if (isolation.pids) {
            EXPECT_EQ(outcome.end, End::process_limit) << why(outcome, limits);
        }
    }
}

TEST_P(Sandbox, OutputIsLimitedAndCut) {
    const Outcome outcome = attack({"print"});
    EXPECT_EQ(outcome.end, End::output_limit);
    EXPECT_LT(outcome.output.size(), 100'000u);
    EXPECT_THAT(outcome.output, HasSubstr("[... cut here ...]"));
}

TEST_P(Sandbox, FilesAreLimited) {
    EXPECT_EQ(attack({"large", work.path()}).end, End::output_limit);
    if (!isolation.mounts) return;
    EXPECT_THAT(attack({"fill", work.path()}).output, HasSubstr("No space left"));
    WorkFolder few(isolation, 8 << 20, 100);
    const Outcome many = run({RAYLAB_ATTACKER, "many", few.path()},
                             {.readable = {std::filesystem::path(RAYLAB_ATTACKER)},
                              .writable = {few.path()},
                              .limits = limits},
                             isolation);
    EXPECT_THAT(many.output, HasSubstr("No space left"));
}

TEST_P(Sandbox, SharedMemoryCountsAsMemory) {
    if (GetParam() != Tier::isolated) return; // the others do not see /dev/shm
    EXPECT_NE(attack({"fill", "/dev/shm"}).output.find("No space left"), std::string::npos);
}

TEST_P(Sandbox, ItSeesWhatItWasGiven) {
    const std::string secret =
        std::filesystem::temp_directory_path() / fmt::format("secret-{}", getpid());
    std::ofstream(secret) << "the reference\n";
    const Outcome read = attack({"read", secret});
    EXPECT_EQ(read.exit_code, closed() ? 0 : 1) << read.output;
    if (closed()) {
        EXPECT_EQ(attack({"write", "/usr/written"}).exit_code, 0);
        EXPECT_EQ(attack({"read", "/root"}).exit_code, 0);
        EXPECT_EQ(attack({"read", fmt::format("/proc/{}/environ", getpid())}).exit_code, 0);
    }
    EXPECT_EQ(attack({"write", work.path() / "out"}).exit_code, 1);
    EXPECT_EQ(read_output(work.path(), "out", 100).bytes, "x");
    std::filesystem::remove(secret);
}

TEST_P(Sandbox, NothingLeadsOut) {
    if (!closed()) return;
    for (const char* way : {"connect", "open"}) {
        const Outcome outcome = attack({way});
        EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
    }
}

TEST_P(Sandbox, ItKillsNobody) {
    if (!closed()) return; // this test would be killed
    const pid_t bystander = fork();
    if (bystander == 0) {
        pause();
        _exit(0);
    }
    attack({"kill"});
    EXPECT_EQ(waitpid(bystander, nullptr, WNOHANG), 0) << "it was killed";
    kill(bystander, SIGKILL);
    waitpid(bystander, nullptr, 0);
}

TEST_P(Sandbox, NothingStaysBehind) {
    const std::filesystem::path file = work.path() / "alive";
    EXPECT_TRUE(attack({"stay", file}).succeeded());
    if (!isolation.own_user && !isolation.pids && isolation.tier == Tier::limited) return;
    std::error_code none;
    const auto before = std::filesystem::exists(file) ? std::filesystem::file_size(file, none) : 0;
    std::this_thread::sleep_for(std::chrono::milliseconds(350));
    const auto after = std::filesystem::exists(file) ? std::filesystem::file_size(file, none) : 0;
    EXPECT_EQ(before, after);
}

TEST_P(Sandbox, ItInheritsNothingButItsHandles) {
    const int open_here = open("/dev/null", O_RDONLY); // not marked to be closed
    setenv("RAYLAB_SECRET", "key", 1);
    if (GetParam() != Tier::confined) { // there /proc cannot be seen
        EXPECT_EQ(attack({"handles"}).output, "");
    }
    const std::string environment = attack({"environment"}).output;
    EXPECT_THAT(environment, HasSubstr("GIVEN=yes"));
    EXPECT_THAT(environment, Not(HasSubstr("RAYLAB_SECRET")));
    close(open_here);

    int in[2], out[2];
    ASSERT_EQ(pipe(in) + pipe(out), 0);
    ASSERT_EQ(write(in[1], "nonce", 5), 5);
    EXPECT_TRUE(attack({"says"}, {{3, in[0]}, {4, out[1]}}).succeeded());
    close(out[1]);
    char said[16] = {};
    EXPECT_EQ(read(out[0], said, sizeof said), 5);
    EXPECT_STREQ(said, "nonce");
    for (const int handle : {in[0], in[1], out[0]}) close(handle);
}

// The figure that the page on grading gives: what a run costs beside the program itself.
TEST_P(Sandbox, ARunCostsLittle) {
    std::vector<double> milliseconds;
    for (int i = 0; i < 31; ++i) {
        const Outcome outcome = attack({"exit", "0"});
        ASSERT_TRUE(outcome.succeeded());
        milliseconds.push_back(1e3 * outcome.seconds);
    }
    std::sort(milliseconds.begin(), milliseconds.end());
    fmt::print("tier {}: {:.1f} ms a run (median of 31; least {:.1f})\n",
               static_cast<int>(GetParam()), milliseconds[15], milliseconds[0]);
    EXPECT_LT(milliseconds[0], 50);
}

} // namespace
} // namespace raylab::sandbox
