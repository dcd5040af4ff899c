// What a signal that ends the program must not leave behind: files under temporary names, and
// children that would run on. They are written down where a signal handler may read.
#pragma once

#include <array>
#include <atomic>
#include <climits>
#include <sys/types.h>

namespace raylab {

// A file under its temporary name. This class only notes the name; whoever made the file removes
// it.
class UnfinishedFile {
  public:
    explicit UnfinishedFile(const char* path); // at most PATH_MAX bytes, or no file could have it
    ~UnfinishedFile();
    UnfinishedFile(const UnfinishedFile&) = delete;
    UnfinishedFile& operator=(const UnfinishedFile&) = delete;
    const char* path() const { return path_.data(); }

  private:
    std::array<char, PATH_MAX> path_;
    std::atomic<const char*>* slot_;
};

// A child process that leads a process group of its own. Make the object before the child is
// started: a signal that comes in between then waits until the child's number is known.
class RunningChild {
  public:
    RunningChild();
    ~RunningChild();
    RunningChild(const RunningChild&) = delete;
    RunningChild& operator=(const RunningChild&) = delete;

    void started(pid_t child); // 0: the child could not be started. Call once

  private:
    std::atomic<pid_t>* slot_ = nullptr;
};

// Removes the files, kills the children and ends the program at once; status: not 0. A signal
// handler may call it. Returns only while another thread is starting a child: that thread then ends
// the program.
void end_without_leftovers(int status);

} // namespace raylab
