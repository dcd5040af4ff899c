// A folder that a program in the sandbox may write to, and how its files are read afterwards.
#pragma once

#include "grader/sandbox/tier.h"

#include <filesystem>
#include <string>

namespace raylab::sandbox {

// Owned by the sandbox's user. Where the grader can mount, it is a tmpfs of this size and number of
// files, which counts as memory of the programs that write to it. The destructor removes it.
class WorkFolder {
  public:
    // Throws std::system_error.
    WorkFolder(const Isolation& isolation, std::uint64_t bytes, int files);
    ~WorkFolder();
    WorkFolder(const WorkFolder&) = delete;
    WorkFolder& operator=(const WorkFolder&) = delete;
    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
    bool mounted_ = false;
};

// Gives a file or folder, with all that is in it, to the sandbox's user, if it has one.
void give_to_sandbox(const std::filesystem::path& path, const Isolation& isolation);

struct OutputFile {
    std::string bytes;
    std::string trouble; // not empty: it was not read, and why
};

// Reads a file that an untrusted program has written, once, after all its processes have ended. It
// must be a regular file with one name, directly in `folder`, of at most `max_bytes`: no link leads
// elsewhere, no pipe makes the grader wait.
OutputFile read_output(const std::filesystem::path& folder, const std::string& name,
                       std::uint64_t max_bytes);

} // namespace raylab::sandbox
