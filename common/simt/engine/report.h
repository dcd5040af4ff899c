// Faults in words: what happened, in which kernel, where everybody is, what was expected, what to
// do.
#pragma once

#include "common/simt/engine/block.h"

#include <string>

namespace raylab::simt {

class Report {
  public:
    explicit Report(const Block& block) : block_(block) {}

    // Every thread that has not ended waits, and no one can go on.
    std::string stuck() const;

    // The running thread names a mask without its own lane.
    std::string not_in_mask(const Site& site, unsigned mask) const;

    std::string trapped(const Site& site) const;
    std::string no_stacks() const;

    // "thread (3,0,0) of block (0,0,0) of kernel k"
    std::string running() const;

  private:
    std::string exited_before_warp(int thread, int exited) const;
    std::string different_operations(int thread, int other) const;
    std::string different_barriers() const;
    std::string exited_before_barrier() const;
    std::string head(const Site& site, const std::string& what, int thread) const;
    std::string everybody() const;
    std::string thread_name(int thread) const;

    const Block& block_;
};

// A warp or block operation outside of a kernel.
std::string outside_of_kernel(const Site& site);

// Writes the message to stderr and ends the program.
[[noreturn]] void end_with_message(const std::string& message);

// "(8,4,1)"
std::string to_string(uint3 v);

// "labs/trace.cu:41"
std::string place(const char* file, int line);
std::string place(const Where& where);

} // namespace raylab::simt
