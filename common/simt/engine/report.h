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

    // The thread shuffles a value from a lane that is not there, or not in the mask.
    std::string bad_source(int thread) const;

    std::string trapped(const Site& site) const;

    // crash_report.cpp: the processor stopped the running thread; an assert() of its failed; it
    // wrote over its own stack, as is seen where a function ends; it has run for so long.
    std::string crashed(const Fault& fault) const;
    std::string failed_assertion(const char* condition, const char* file, int line) const;
    std::string overwritten(const void* pc) const;
    std::string still_running(const Fault& fault, double seconds) const;

    std::string no_stacks() const;

    // "thread (3,0,0) of block (0,0,0) of kernel k"
    std::string running() const;

  private:
    std::string exited_before_warp(int thread, int exited) const;
    std::string different_operations(int thread, int other) const;
    std::string different_barriers() const;
    std::string exited_before_barrier() const;
    std::string bad_address(const Fault& fault) const;
    std::string head(const Fault& fault, const std::string& what) const;
    std::string head(const Site& site, const std::string& what, int thread) const;
    std::string head(const std::string& where, const std::string& what, int thread) const;
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
