// What a signal that ends the program must not leave behind: files under temporary names, and
// children that would run on. They are written down where a signal handler may read.
#pragma once

#include <array>
#include <atomic>
#include <climits>
#include <sys/types.h>

namespace raylab {

// A file that has not yet its name. Removes nothing itself: that is for whoever made the file.
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

// A child that leads a process group of its own. Make the object before the child is started: a
// signal then waits until it is known whom to kill.
class RunningChild {
  public:
    RunningChild();
    ~RunningChild();
    RunningChild(const RunningChild&) = delete;
    RunningChild& operator=(const RunningChild&) = delete;

    void started(pid_t child); // 0: it could not be. Call it once

  private:
    std::atomic<pid_t>* slot_ = nullptr;
};

// Removes the files, kills the children and ends the program at once; status: not 0. For signal
// handlers too. Returns only while a child is being started: whoever does that then ends the
// program.
void end_without_leftovers(int status);

} // namespace raylab
