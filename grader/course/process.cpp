#include "grader/course/process.h"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

namespace raylab {

namespace {

[[noreturn]] void fail(int error, const std::string& what) {
    throw std::system_error(error, std::generic_category(), what);
}

// In the child, between fork and exec: only calls that are safe there.
[[noreturn]] void become(char* const* arguments, const char* folder, int output, int report) {
    setpgid(0, 0); // a group of its own, to be killed as one
    const int nothing = open("/dev/null", O_RDONLY);
    if (nothing >= 0 && dup2(nothing, STDIN_FILENO) >= 0 && dup2(output, STDOUT_FILENO) >= 0 &&
        dup2(output, STDERR_FILENO) >= 0 && chdir(folder) == 0)
        execvp(arguments[0], arguments);
    const int error = errno;
    [[maybe_unused]] const ssize_t told = write(report, &error, sizeof error);
    _exit(127);
}

// Reads until the other end is closed or the time is up; false if it was up.
bool read_until(int fd, std::string& text, std::chrono::steady_clock::time_point deadline,
                const std::function<void(const std::string&)>& watch) {
    char block[1 << 14];
    for (;;) {
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(
            deadline - std::chrono::steady_clock::now());
        if (left.count() <= 0) return false;
        pollfd ready{fd, POLLIN, 0};
        const int events =
            poll(&ready, 1, static_cast<int>(std::min<long long>(left.count(), 1000)));
        if (events <= 0) continue;
        const ssize_t n = read(fd, block, sizeof block);
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) return true;
        text.append(block, static_cast<std::size_t>(n));
        if (watch) watch(text);
    }
}

} // namespace

ProcessOutcome run_process(const std::vector<std::string>& command,
                           const std::filesystem::path& folder, double limit_seconds,
                           const std::function<void(const std::string&)>& watch) {
    const auto start = std::chrono::steady_clock::now();
    std::vector<char*> arguments;
    for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);

    int output[2], report[2]; // report: closed by a successful exec
    if (pipe2(output, O_CLOEXEC) != 0) fail(errno, "pipe");
    if (pipe2(report, O_CLOEXEC) != 0) fail(errno, "pipe");
    const pid_t child = fork();
    if (child < 0) fail(errno, "fork");
    if (child == 0) become(arguments.data(), folder.c_str(), output[1], report[1]);
    close(output[1]);
    close(report[1]);

    int error = 0;
    const bool started = read(report[0], &error, sizeof error) <= 0;
    close(report[0]);
    ProcessOutcome outcome;
    if (started)
        outcome.timed_out =
            !read_until(output[0], outcome.output,
                        start + std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                                    std::chrono::duration<double>(limit_seconds)),
                        watch);
    close(output[0]);
    if (outcome.timed_out) kill(-child, SIGKILL);
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    if (!started) fail(error, "cannot run " + command[0]);
    outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    outcome.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    outcome.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return outcome;
}

} // namespace raylab
