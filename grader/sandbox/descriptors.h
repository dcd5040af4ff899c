// Open descriptors of the grader's that a sandbox's process gets, and that are closed at the end.
#pragma once

#include <cerrno>
#include <fcntl.h>
#include <string>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace raylab::sandbox {

// From here on descriptors are not overwritten when the program's are given numbers.
constexpr int first_high_handle = 100;

// A descriptor that is closed at the end.
class Handle {
  public:
    explicit Handle(int number = -1) : number_(number) {}
    ~Handle() { reset(); }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    int get() const { return number_; }
    void reset(int number = -1) {
        if (number_ >= 0) close(number_);
        number_ = number;
    }

  private:
    int number_;
};

// The same file by another descriptor, out of the way of the program's numbers.
inline int high_handle(int handle) { return fcntl(handle, F_DUPFD_CLOEXEC, first_high_handle); }

struct Pipe {
    Handle read, write;
    Pipe() {
        int both[2];
        if (pipe2(both, O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category());
        for (const auto& [handle, number] : {std::pair{&read, both[0]}, {&write, both[1]}}) {
            handle->reset(high_handle(number));
            close(number);
        }
    }
};

// All bytes until the end of the file, or until none are there where reading does not wait.
inline std::string all_of(int handle) {
    std::string text;
    char buffer[4096];
    for (ssize_t n; (n = read(handle, buffer, sizeof buffer)) > 0;)
        text.append(buffer, static_cast<std::size_t>(n));
    return text;
}

} // namespace raylab::sandbox
