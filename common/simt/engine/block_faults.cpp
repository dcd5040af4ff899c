// How a kernel's mistakes leave a block; see block.h. (Barriers and masks: report.cpp.)
#include "common/simt/engine/block.h"

#include "common/simt/engine/findings.h"
#include "common/simt/engine/machine.h"
#include "common/simt/engine/report.h"
#include "common/simt/watch/events.h"

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <set>

namespace raylab::simt {

void Block::crash(const Fault& fault) {
    crash_ = fault;
    fault_code_ = fault.signal == SIGSEGV || fault.signal == SIGBUS ? cudaErrorIllegalAddress
                                                                    : cudaErrorLaunchFailure;
    if (check_build) {
        remember_fault(fault_code_, Report(*this).crashed(fault));
        write_summary();
        std::fflush(stdout);
        std::_Exit(1);
    }
    switch_fiber(*current_, home_, true);
    __builtin_unreachable();
}

void Block::fail_assertion(const char* condition, const char* file, int line) {
    give_up(Report(*this).failed_assertion(condition, file, line), cudaErrorAssert);
}

void Block::overwrite(const void* end_of_function) {
    give_up(Report(*this).overwritten(end_of_function), cudaErrorIllegalAddress);
}

bool Block::is_stack_overflow(const void* address) const {
    const auto byte = static_cast<const char*>(address);
    return current_ && byte < current_->bottom && byte >= current_->bottom - stack_guard_bytes;
}

bool Block::interrupt(int signal) { return is_running_ && pthread_kill(runs_on_, signal) == 0; }

std::string Block::still_running(const Fault& fault, double seconds) const {
    return Report(*this).still_running(fault, seconds);
}

void Block::trap(const Site& site) {
    watch::pause();
    give_up(Report(*this).trapped(site));
}

void Block::fail(const Site& site, const char* what, const char* to_do) {
    // What is alive when the thread is left is never destroyed: nothing must be but the report.
    auto report = [&] {
        const Launch& launch = work_->launch;
        return place(site.file, site.line) + ": error: " + what + "\n  kernel " + launch.kernel +
               ", launched at " + place(launch.file, launch.line) + ", grid " +
               to_string(launch.grid) + ", block size " + to_string(launch.block) + "\n  block " +
               to_string(blockIdx) + ", thread " + to_string(threadIdx) + "\n  to do: " + to_do;
    };
    give_up(report());
}

Actor Block::actor() const {
    const uint3 thread = index_[running_];
    return {work_->launch.kernel, Index3{blockIdx.x, blockIdx.y, blockIdx.z},
            Index3{thread.x, thread.y, thread.z}};
}

std::string Block::running() const { return Report(*this).running(); }

// A shuffle reads a lane that brings nothing. In a reduction's later steps the upper lanes do, and
// nobody uses what they get; where the lowest lane does, it is a mistake.
void Block::warn_once(int thread) const {
    static std::mutex mutex;
    static auto* known = new std::set<const Site*>;
    std::lock_guard lock(mutex);
    if (known->insert(waiters_[thread].site).second) warn(Report(*this).bad_source(thread));
}

} // namespace raylab::simt
