// posix_spawn with a pipe: the child is over when its end of the pipe closes.
#include "grader/bench/process.h"

#include <fmt/format.h>

#include <cctype>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sstream>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace raylab::bench {

namespace {

constexpr std::size_t kept_output = 64 << 10;

double now() {
    using namespace std::chrono;
    return duration<double>(steady_clock::now().time_since_epoch()).count();
}

// Starts the program in a process group of its own, its output to `pipe_end`. 0, or an errno.
int start(const std::vector<std::string>& command, int pipe_end, pid_t& child) {
    std::vector<char*> arguments;
    for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawnattr_t attributes;
    posix_spawn_file_actions_init(&actions);
    posix_spawnattr_init(&attributes);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, pipe_end, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, pipe_end, STDERR_FILENO);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    const int error =
        posix_spawnp(&child, arguments[0], &actions, &attributes, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
    return error;
}

} // namespace

ProcessResult run_process(const std::vector<std::string>& command, double limit) {
    ProcessResult result;
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) {
        result.failure = fmt::format("could not be started: {}", std::strerror(errno));
        return result;
    }
    const double begin = now();
    pid_t child = 0;
    const int error = start(command, ends[1], child);
    close(ends[1]);
    if (error != 0) {
        close(ends[0]);
        result.failure = fmt::format("could not be started: {}", std::strerror(error));
        return result;
    }
    char block[4096];
    for (;;) {
        const double left = begin + limit - now();
        pollfd watched = {ends[0], POLLIN, 0};
        const int ready = left > 0 ? poll(&watched, 1, static_cast<int>(1000 * left) + 1) : 0;
        if (ready < 0 && errno == EINTR) continue;
        if (ready <= 0) {
            result.timed_out = true;
            result.failure = fmt::format("timed out after {:.0f} s", limit);
            kill(-child, SIGKILL);
            break;
        }
        const ssize_t n = read(ends[0], block, sizeof block);
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) break;
        result.output.append(block, static_cast<std::size_t>(n));
        if (result.output.size() > 2 * kept_output)
            result.output.erase(0, result.output.size() - kept_output);
    }
    close(ends[0]);
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    result.seconds = now() - begin;
    if (WIFEXITED(status)) result.exit_code = WEXITSTATUS(status);
    if (WIFSIGNALED(status) && !result.timed_out)
        result.failure = fmt::format("was ended by signal {} ({})", WTERMSIG(status),
                                     strsignal(WTERMSIG(status)));
    return result;
}

std::string why_failed(const ProcessResult& result) {
    const std::string what =
        result.failure.empty() ? fmt::format("exit status {}", result.exit_code) : result.failure;
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
    return result.timed_out || words.empty() ? what : what + ": " + words;
}

} // namespace raylab::bench
