// Faults in words; see report.h.
#include "common/simt/engine/report.h"

#include <bit>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace raylab::simt {

std::string to_string(uint3 v) {
    return "(" + std::to_string(v.x) + "," + std::to_string(v.y) + "," + std::to_string(v.z) + ")";
}

std::string place(const char* file, int line) {
    return std::string(file) + ":" + std::to_string(line);
}

std::string place(const Where& where) { return place(where.file, where.line); }

static std::string place(const Site& site) { return place(site.file, site.line); }

static std::string hexadecimal(unsigned mask) {
    char text[16];
    std::snprintf(text, sizeof text, "0x%08x", mask);
    return text;
}

static std::string count_threads(int count) {
    return std::to_string(count) + (count == 1 ? " thread" : " threads");
}

std::string Report::thread_name(int thread) const {
    return "thread " + to_string(block_.index_[thread]);
}

// "f.cu:41: error: WHAT" and below it which kernel, block and thread.
std::string Report::head(const Site& site, const std::string& what, int thread) const {
    return head(place(site), what, thread);
}

std::string Report::head(const std::string& where, const std::string& what, int thread) const {
    const Launch& launch = block_.work_->launch;
    return where + ": error: " + what + "\n  kernel " + launch.kernel + ", launched at " +
           place(launch.file, launch.line) + ", grid " + to_string(launch.grid) + ", block size " +
           to_string(launch.block) + "\n  block " + to_string(blockIdx) + ", " +
           thread_name(thread) + "\n";
}

std::string Report::running() const {
    return thread_name(block_.running_) + " of block " + to_string(blockIdx) + " of kernel " +
           block_.work_->launch.kernel;
}

// One line for each place where threads wait, in the order of the first thread there.
std::string Report::everybody() const {
    struct Group {
        const Site* site;
        unsigned mask;
        int first, count;
    };
    std::vector<Group> groups;
    int ended = 0;
    for (int thread = 0; thread < block_.count_; ++thread) {
        const auto& waiter = block_.waiters_[thread];
        if (block_.status_[thread] == Block::Status::ended) ++ended;
        if (block_.status_[thread] != Block::Status::waiting) continue;
        unsigned mask = waiter.kind == Wait::block ? 0 : waiter.mask;
        bool known = false;
        for (Group& group : groups)
            if (group.site == waiter.site && group.mask == mask) {
                ++group.count;
                known = true;
            }
        if (!known) groups.push_back({waiter.site, mask, thread, 1});
    }
    std::string text;
    for (const Group& group : groups)
        text += "  " + place(*group.site) + ": " + count_threads(group.count) +
                (group.count == 1 ? " waits" : " wait") + " at " + group.site->operation +
                (group.mask ? " with mask " + hexadecimal(group.mask) : "") + ", the first is " +
                thread_name(group.first) + "\n";
    if (ended)
        text += "  " + count_threads(ended) + (ended == 1 ? " has" : " have") + " returned\n";
    return text;
}

// Why no one can go on: look at the lowest thread that waits for lanes of its warp, and at the
// block's barrier if there is none.
std::string Report::stuck() const {
    for (int thread = 0; thread < block_.count_; ++thread) {
        const auto& waiter = block_.waiters_[thread];
        if (block_.status_[thread] != Block::Status::waiting || waiter.kind == Wait::block)
            continue;
        int warp = thread / lanes;
        for (unsigned rest = waiter.mask & block_.existing(warp); rest; rest &= rest - 1) {
            int other = warp * lanes + std::countr_zero(rest);
            if (block_.status_[other] == Block::Status::ended)
                return exited_before_warp(thread, other);
        }
        for (unsigned rest = waiter.mask & block_.existing(warp); rest; rest &= rest - 1) {
            int other = warp * lanes + std::countr_zero(rest);
            const auto& its = block_.waiters_[other];
            if (!Block::meet(waiter, its)) return different_operations(thread, other);
        }
    }
    return block_.same_site_ ? exited_before_barrier() : different_barriers();
}

std::string Report::exited_before_warp(int thread, int exited) const {
    const auto& waiter = block_.waiters_[thread];
    return head(*waiter.site,
                std::string("bad mask: ") + waiter.site->operation + " names lane " +
                    std::to_string(exited % lanes) + ", which has returned from the kernel",
                thread) +
           everybody() + "  expected: every lane in the mask " + hexadecimal(waiter.mask) +
           " comes here\n  to do: let " + thread_name(exited) +
           " come here too, or take the mask while all lanes are there: unsigned mask = "
           "__ballot_sync(0xffffffff, condition)";
}

std::string Report::different_operations(int thread, int other) const {
    const auto& waiter = block_.waiters_[thread];
    const auto& its = block_.waiters_[other];
    bool other_at_barrier = its.kind == Wait::block;
    std::string what =
        other_at_barrier
            ? std::string("deadlock: lanes of one warp wait at ") + waiter.site->operation +
                  " for lanes that wait at " + its.site->operation
        : its.site == waiter.site
            ? std::string("bad mask: lanes of one warp are at the same ") + its.site->operation +
                  " with different masks"
            : "bad mask: lanes of one warp that name each other are at different operations";
    return head(*waiter.site, what, thread) + everybody() + "  expected: the lanes in the mask " +
           hexadecimal(waiter.mask) + " are all at this operation with this mask\n  to do: " +
           (other_at_barrier || its.site != waiter.site
                ? "move the operation out of the branch, or name in each branch only the lanes "
                  "that take it"
                : "compute the mask where all lanes are together, before the branch");
}

std::string Report::different_barriers() const {
    int first = block_.arrivals_[0], other = first;
    for (int i = 0; i < block_.arrived_; ++i)
        if (block_.waiters_[block_.arrivals_[i]].site != block_.waiters_[first].site) {
            other = block_.arrivals_[i];
            break;
        }
    if (other < first) std::swap(first, other);
    return head(*block_.waiters_[first].site,
                "divergent barrier: the threads of one block wait at different barriers", first) +
           everybody() + "  expected: all threads of the block reach the same " +
           block_.waiters_[first].site->operation +
           "\n  to do: move the barrier out of the branch or loop that only some threads take";
}

std::string Report::exited_before_barrier() const {
    int ended = 0, first_waiting = -1;
    for (int thread = block_.count_ - 1; thread >= 0; --thread)
        if (block_.status_[thread] == Block::Status::ended)
            ended = thread;
        else if (block_.status_[thread] == Block::Status::waiting)
            first_waiting = thread;
    const Site& site = *block_.waiters_[first_waiting].site;
    return head(site,
                "exit before a barrier: " + thread_name(ended) + " returned while others wait at " +
                    site.operation,
                first_waiting) +
           everybody() + "  expected: all " + std::to_string(block_.count_) +
           " threads of the block reach " + site.operation +
           "\n  to do: instead of returning early, let such threads skip the work but not the "
           "barrier: if (i < n) { ... } __syncthreads();";
}

std::string Report::not_in_mask(const Site& site, unsigned mask) const {
    return head(site,
                std::string("bad mask: lane ") + std::to_string(block_.running_ % lanes) +
                    " calls " + site.operation + " with mask " + hexadecimal(mask) +
                    ", which does not name it",
                block_.running_) +
           "  expected: the mask names every lane that comes here, also the caller\n  to do: give "
           "0xffffffff if all lanes of the warp come here, else the __ballot_sync() of those that "
           "do";
}

std::string Report::bad_source(int thread) const {
    const auto& waiter = block_.waiters_[thread];
    const unsigned existing = block_.existing(thread / lanes);
    const bool exists = existing >> waiter.source & 1;
    return head(*waiter.site,
                std::string("bad source: ") + waiter.site->operation + " reads lane " +
                    std::to_string(waiter.source) +
                    (exists ? ", which the mask " + hexadecimal(waiter.mask) + " does not name"
                            : ", and the last warp of the block has only " +
                                  std::to_string(std::popcount(existing)) + " lanes"),
                thread) +
           "  expected: every lane that is read comes here with a value\n  to do: " +
           (exists ? "name in the mask every lane that is read"
                   : "launch a multiple of 32 threads and let those beyond the end bring 0, or use "
                     "__ballot_sync() and read only lanes that are in it");
}

std::string Report::trapped(const Site& site) const {
    return head(site, "the kernel called __trap()", block_.running_);
}

std::string Report::no_stacks() const {
    const Launch& launch = block_.work_->launch;
    return place(launch.file, launch.line) + ": error: no memory for the stacks of kernel " +
           launch.kernel + ": " + std::to_string(block_.options_.stack_size) +
           " bytes for each of " + std::to_string(block_.count_) +
           " threads that wait at a barrier\n  to do: smaller "
           "blocks, fewer worker threads or a smaller Options::stack_size";
}

std::string outside_of_kernel(const Site& site) {
    return place(site) + ": error: " + site.operation +
           " was called by host code\n  expected: it "
           "is called in a kernel, launched with <<<...>>>";
}

void end_with_message(const std::string& message) {
    std::fputs((message + "\n").c_str(), stderr);
    std::abort();
}

} // namespace raylab::simt
