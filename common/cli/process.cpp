// posix_spawn with a pipe. The limit holds for the output and for the end: a child may close its
// output and run on, or leave a grandchild that keeps the pipe open.
#include "common/cli/process.h"

#include "common/cli/deadline.h"
#include "common/cli/leftovers.h"
#include "common/math/index.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <chrono>
#include <climits>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sstream>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

extern char** environ;

namespace raylab {

namespace {

constexpr std::size_t kept_output = 4 << 20;

// A pipe whose ends no program inherits that is started meanwhile. macOS has no pipe2(): there
// another thread may start one between the two calls, and its child keeps the pipe open until it
// ends.
bool make_pipe(int ends[2]) {
#if defined(__APPLE__)
    return pipe(ends) == 0 && fcntl(ends[0], F_SETFD, FD_CLOEXEC) == 0 &&
           fcntl(ends[1], F_SETFD, FD_CLOEXEC) == 0;
#else
    return pipe2(ends, O_CLOEXEC) == 0;
#endif
}

// Starts the program in a process group of its own, its output to `pipe_end`. 0, or an errno.
int start(const std::vector<std::string>& command, const ProcessOptions& options, int pipe_end,
          pid_t& child) {
    const std::filesystem::path& folder = options.folder;
    using Errors = ProcessOptions::Errors;
    std::vector<char*> arguments;
    for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawnattr_t attributes;
    posix_spawn_file_actions_init(&actions);
    posix_spawnattr_init(&attributes);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, pipe_end, STDOUT_FILENO);
    if (options.errors == Errors::in_output)
        posix_spawn_file_actions_adddup2(&actions, pipe_end, STDERR_FILENO);
    if (options.errors == Errors::to_file)
        posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, options.error_file.c_str(),
                                         O_WRONLY | O_CREAT | O_TRUNC, 0666);
    if (!folder.empty()) posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF);
    sigset_t as_by_default; // the child gets default actions, also for signals ignored here
    sigemptyset(&as_by_default);
    sigaddset(&as_by_default, SIGXFSZ);
    posix_spawnattr_setsigdefault(&attributes, &as_by_default);
    const int error =
        posix_spawnp(&child, arguments[0], &actions, &attributes, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
    return error;
}

// Reads until all processes have closed the other end; false if the time was up before.
bool read_output(int pipe_end, Deadline& deadline, const ProcessOptions& options,
                 std::string& output) {
    char block[1 << 14];
    for (;;) {
        const double left = deadline.left();
        pollfd watched = {pipe_end, POLLIN, 0};
        const double wait = options.tick ? std::min(left, 0.2) : left;
        const int ready = left > 0 ? poll(&watched, 1, 1 + index_of(1000 * wait, INT_MAX)) : 0;
        if (ready < 0 && errno == EINTR) continue;
        if (ready == 0 && wait < left) {
            options.tick();
            continue;
        }
        if (ready == 0 && deadline.left() > 0) continue;
        if (ready <= 0) return false;
        const ssize_t n = read(pipe_end, block, sizeof block);
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) return true;
        output.append(block, static_cast<std::size_t>(n));
        if (output.size() > 2 * kept_output) output.erase(0, output.size() - kept_output);
        if (options.watch) options.watch(output);
    }
}

// Waits until the child ends; false if the time was up before.
bool wait_for_end(pid_t child, Deadline& deadline, int& status) {
    for (;;) {
        const pid_t ended = waitpid(child, &status, WNOHANG);
        if (ended != 0 && !(ended < 0 && errno == EINTR)) return true;
        if (deadline.left() <= 0) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
}

// Waits until the child's output and the child end. If the time is up before, kills it and returns
// false.
bool is_over(pid_t child, int pipe_end, const ProcessOptions& options, std::string& output,
             int& status) {
    Deadline deadline(child, options.limit_seconds, options.limit_on_a_busy_machine);
    if (read_output(pipe_end, deadline, options, output) && wait_for_end(child, deadline, status))
        return true;
    kill(-child, SIGKILL);
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    return false;
}

} // namespace

ProcessResult run_process(const std::vector<std::string>& command, const ProcessOptions& options) {
    ProcessResult result;
    const auto not_started = [&result](int error) {
        result.output = std::strerror(error);
        return result;
    };
    int ends[2];
    if (!make_pipe(ends)) return not_started(errno);
    const double begin = now();
    int error = 0, status = 0;
    {
        RunningChild running;
        pid_t child = 0;
        error = start(command, options, ends[1], child);
        result.started = error == 0;
        running.started(result.started ? child : 0);
        close(ends[1]);
        if (result.started)
            result.timed_out = !is_over(child, ends[0], options, result.output, status);
    }
    close(ends[0]);
    if (!result.started) return not_started(error);
    result.seconds = now() - begin;
    if (WIFSIGNALED(status)) result.signal = WTERMSIG(status);
    if (WIFEXITED(status) && !result.timed_out) result.exit_code = WEXITSTATUS(status);
    return result;
}

std::string in_quotes(const std::string& word) {
    std::string text = "'";
    for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return text + "'";
}

std::string why_failed(const ProcessResult& result) {
    if (!result.started) return "could not be started: " + result.output;
    if (result.timed_out) return fmt::format("timed out after {:.0f} s", result.seconds);
    const std::string what =
        result.signal == 0
            ? fmt::format("exit status {}", result.exit_code)
            : fmt::format("was ended by signal {} ({})", result.signal, strsignal(result.signal));
    // The last exception of Python's, or else the last line that speaks of an error, or says
    // anything.
    std::istringstream lines(result.output);
    std::string said, error, exception;
    for (std::string line; std::getline(lines, line);) {
        if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
        said = line;
        const std::size_t at = line.find("rror");
        if (at != std::string::npos) error = line;
        if (at != std::string::npos && at > 1 && std::isalpha(line[at - 2])) exception = line;
    }
    const std::string& words = !exception.empty() ? exception : !error.empty() ? error : said;
    return words.empty() ? what : what + ": " + words;
}

} // namespace raylab
