// Runs a command as a person does, and returns its output and its exit code.
#pragma once

#include <algorithm>
#include <array>
#include <cstdio>
#if defined(__APPLE__)
#include <util.h>
#else
#include <pty.h>
#endif
#include <string>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace raylab::app {

struct Outcome {
    int code;         // -1: it did not end by itself
    std::string text; // standard output and standard error
};

inline Outcome run_in_shell(const std::string& command) {
    FILE* pipe = popen((command + " 2>&1").c_str(), "r");
    Outcome outcome{-1, ""};
    std::array<char, 4096> buffer;
    while (const std::size_t n = fread(buffer.data(), 1, buffer.size(), pipe))
        outcome.text.append(buffer.data(), n);
    const int status = pclose(pipe);
    outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return outcome;
}

// The same on a terminal, which after each piece of output gets the next of the widths; the last
// stays.
inline Outcome run_on_terminal(const std::string& command, const std::vector<int>& widths) {
    winsize size{24, static_cast<unsigned short>(widths.front()), 0, 0};
    int terminal = -1;
    const pid_t child = forkpty(&terminal, nullptr, nullptr, &size);
    if (child == 0) {
        execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
        _exit(127);
    }
    Outcome outcome{-1, ""};
    std::array<char, 4096> buffer;
    std::size_t next = 1;
    for (ssize_t n; (n = read(terminal, buffer.data(), buffer.size())) > 0;) { // ends with EIO
        outcome.text.append(buffer.data(), static_cast<std::size_t>(n));
        if (next == widths.size()) continue;
        size.ws_col = static_cast<unsigned short>(widths[next++]);
        ioctl(terminal, TIOCSWINSZ, &size);
    }
    int status = 0;
    waitpid(child, &status, 0);
    close(terminal);
    outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return outcome;
}

// The widest of the lines that were drawn again and again; -1 if there was none. What follows the
// removal of the last is an ordinary line.
inline int widest_progress(const std::string& text) {
    const std::string begin = "\r\033[K";
    int widest = -1;
    std::size_t at = text.find(begin);
    while (at != text.npos) {
        const std::size_t from = at + begin.size(), end = text.find('\r', from);
        at = text.find(begin, from);
        if (end == at && end != text.npos) widest = std::max(widest, static_cast<int>(end - from));
    }
    return widest;
}

} // namespace raylab::app
