// A control group for one run: memory and processes of all that it starts, together. Versions 1
// and 2.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include <sys/types.h>

namespace raylab::sandbox {

class Cgroup {
  public:
    // Makes it below this process's own group. What cannot be had is left out: see memory() and
    // pids(). No limit where a number is 0.
    Cgroup(std::uint64_t memory_bytes, int processes);
    ~Cgroup(); // kills what is left in it, and removes it
    Cgroup(const Cgroup&) = delete;
    Cgroup& operator=(const Cgroup&) = delete;

    bool memory() const { return !memory_.empty(); }
    bool pids() const { return !pids_.empty(); }
    const std::string& trouble() const { return trouble_; } // why one of them is missing

    void add(pid_t process) const;
    void kill_all() const;

    std::uint64_t peak_memory() const; // bytes; 0: unknown
    bool out_of_memory() const;        // the kernel has killed for want of memory
    bool out_of_pids() const;          // a fork was refused

  private:
    std::filesystem::path memory_, pids_; // the same folder in version 2
    bool version_2_ = false;
    std::string trouble_;
};

} // namespace raylab::sandbox
