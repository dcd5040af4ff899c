// Signals, sent to child processes of this test: how the children end, and what they leave behind.
#include "common/cli/interrupt.h"

#include "common/cli/files.h"
#include "common/cli/leftovers.h"
#include "common/cli/process.h"
#include "common/cli/tests/temporary_folder.h"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace raylab {
namespace {

namespace fs = std::filesystem;
using std::chrono::milliseconds;

// A child that catches signals, tells through a pipe that it is ready, and then runs life().
class Child {
  public:
    explicit Child(const std::function<int()>& life) {
        int ends[2];
        if (pipe(ends) != 0) std::abort();
        pid_ = fork();
        if (pid_ == 0) {
            catch_signals();
            ready_ = ends[1];
            _exit(life());
        }
        close(ends[1]);
        char byte;
        const bool ready = read(ends[0], &byte, 1) == 1;
        EXPECT_TRUE(ready);
        close(ends[0]);
    }
    static void is_ready() { (void)!write(ready_, "!", 1); }
    void send(int signal) const { kill(pid_, signal); }
    int exit_status() const { // -signal if one ended it
        int status = 0;
        waitpid(pid_, &status, 0);
        return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
    }

  private:
    pid_t pid_;
    static inline int ready_ = -1;
};

int sleep_for_ever() {
    Child::is_ready();
    for (;;) pause();
}

TEST(Interrupt, WithNothingToKeepASignalEndsAtOnce) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        const Child child(sleep_for_ever);
        child.send(signal);
        EXPECT_EQ(child.exit_status(), 128 + signal);
    }
}

TEST(Interrupt, WhatIsIgnoredStaysIgnored) {
    signal(SIGHUP, SIG_IGN); // as nohup does
    const Child child(sleep_for_ever);
    signal(SIGHUP, SIG_DFL);
    child.send(SIGHUP);
    std::this_thread::sleep_for(milliseconds(50));
    child.send(SIGTERM);
    EXPECT_EQ(child.exit_status(), 128 + SIGTERM);
}

TEST(Interrupt, WithSomethingToKeepTheFirstIsAQuestionAndTheSecondAnEnd) {
    const auto life = [] {
        const KeepsWork keeping;
        Child::is_ready();
        while (interrupted() == 0) usleep(1000);
        if (interrupted() != SIGINT) return 1;
        for (;;) pause();
    };
    const Child child(life);
    child.send(SIGINT);
    std::this_thread::sleep_for(milliseconds(20));
    child.send(SIGINT); // the same press once more: timeout(1) does that
    std::this_thread::sleep_for(milliseconds(600));
    child.send(SIGTERM);
    EXPECT_EQ(child.exit_status(), 128 + SIGTERM);
}

TEST(Interrupt, ThePressOnceMoreDoesNotEndIt) {
    const Child child([] {
        const KeepsWork keeping;
        Child::is_ready();
        while (interrupted() == 0) usleep(1000);
        usleep(200000);
        return 7;
    });
    child.send(SIGINT);
    std::this_thread::sleep_for(milliseconds(20));
    child.send(SIGINT);
    EXPECT_EQ(child.exit_status(), 7);
}

TEST(Interrupt, WorkThatEndsInTimeIsWaitedForAndOtherWorkIsNot) {
    for (const int work_milliseconds : {200, 30000}) {
        const Child child([work_milliseconds] {
            const KeepsWork keeping;
            Child::is_ready();
            return run_interruptibly(
                       [&] { std::this_thread::sleep_for(milliseconds(work_milliseconds)); }, {},
                       0.5)
                       ? 1
                       : 2;
        });
        child.send(SIGINT);
        EXPECT_EQ(child.exit_status(), work_milliseconds == 200 ? 1 : 2);
    }
}

TEST(Interrupt, WhatTheWorkThrowsIsThrownOn) {
    EXPECT_THROW(run_interruptibly([] { throw FileError("f", ExitCode::tool_failed); }), FileError);
    EXPECT_TRUE(run_interruptibly([] {}));
}

// Whether the process is dead, or a zombie whose parent has not asked for its status yet.
bool ends(pid_t process) {
    const std::string stat = "/proc/" + std::to_string(process) + "/stat";
    for (int i = 0; i < 200; ++i, usleep(10000))
        if (!fs::exists(stat) || read_file(stat).find(") Z ") != std::string::npos) return true;
    return false;
}

// The signal comes after the child was started, and before its number is noted down.
TEST(Interrupt, WhileAChildIsBeingStartedTheEndWaits) {
    int pipe_ends[2];
    ASSERT_EQ(pipe(pipe_ends), 0);
    const Child child([&] {
        RunningChild running;
        const pid_t grandchild = fork();
        if (grandchild == 0) {
            setpgid(0, 0);
            sleep(60);
            _exit(0);
        }
        setpgid(grandchild, grandchild);
        (void)!write(pipe_ends[1], &grandchild, sizeof grandchild);
        Child::is_ready();
        usleep(300000);
        running.started(grandchild);
        return 1;
    });
    child.send(SIGTERM);
    pid_t grandchild = 0;
    ASSERT_EQ(read(pipe_ends[0], &grandchild, sizeof grandchild), ssize_t(sizeof grandchild));
    EXPECT_EQ(child.exit_status(), 128 + SIGTERM);
    EXPECT_TRUE(ends(grandchild));
    close(pipe_ends[0]);
    close(pipe_ends[1]);
}

TEST(Interrupt, NeitherFilesNorChildrenAreLeftBehind) {
    const TemporaryFolder folder;
    const std::string name = folder / "unfinished.part", pid_file = folder / "pid";
    const Child child([&] {
        const UnfinishedFile unfinished(name.c_str());
        write_file(name, "half of it");
        Child::is_ready();
        // A grandchild that writes where it is and would sleep for a minute.
        run_process({"sh", "-c", "echo $$ > " + pid_file + "; sleep 60; true"}, {60});
        return 1;
    });
    while (!fs::exists(pid_file) || fs::file_size(pid_file) == 0) usleep(1000);
    const pid_t grandchild = std::stoi(read_file(pid_file));
    EXPECT_EQ(kill(grandchild, 0), 0);
    child.send(SIGTERM);
    EXPECT_EQ(child.exit_status(), 128 + SIGTERM);
    EXPECT_FALSE(fs::exists(name));
    EXPECT_TRUE(ends(grandchild)) << "the child's child runs on";
}

// Under `ulimit -f` this program's writes fail. Its children must die of SIGXFSZ, as they would in
// a shell.
TEST(Interrupt, ALimitOnFilesIsNotInheritedAsIgnored) {
    const Child child([] {
        Child::is_ready();
        const ProcessResult result =
            run_process({"sh", "-c",
                         "ulimit -f 1; head -c 100000 /dev/zero > /tmp/raylab-xfsz-$$; "
                         "status=$?; rm -f /tmp/raylab-xfsz-$$; exit $status"},
                        {10});
        return result.exit_code == 128 + SIGXFSZ ? 0 : 1;
    });
    EXPECT_EQ(child.exit_status(), 0);
}

} // namespace
} // namespace raylab
