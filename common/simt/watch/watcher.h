// The watch: every load and store of a kernel, looked at as it happens.
//
// The compiler puts a call before each access, as for ThreadSanitizer, and a check before each
// index and division, as for UndefinedBehaviorSanitizer; the functions that it calls are raylab's
// own (hooks.cpp). So one run finds accesses out of bounds, of freed and of host memory, reads of
// what nobody wrote, and races: two accesses of one place, one of them a write, that no barrier,
// fence or atomic orders. The engine tells what happens between the threads. One worker runs all
// blocks, so nothing here needs a lock.
#pragma once

#include "common/simt/finding.h"
#include "common/simt/launch.h"
#include "common/simt/watch/block_clock.h"
#include "common/simt/watch/concurrency.h"
#include "common/simt/watch/race_book.h"
#include "common/simt/watch/shadow.h"
#include "common/simt/watch/traffic.h"
#include "common/simt/where.h"

#include <map>

namespace raylab::simt::watch {

// What allocate() gave.
struct Allocation {
    uintptr_t begin;
    size_t bytes;
    Where where;
    bool is_freed = false;
};

class Watcher {
  public:
    static Watcher& get();

    // What the engine tells.
    void begin_launch(const Launch& launch, bool prints); // findings, to stderr
    void end_launch();
    void begin_block(uint32_t block, int threads, void* dynamic_shared, size_t bytes);
    void go_on(int thread);
    void pause() { // until go_on(): the engine or host code runs
        thread_ = -1;
        quiet_reads.stop();
    }
    void barrier() {
        if (launch_) clock_.barrier();
    }
    void meet(int warp, unsigned members) {
        if (launch_) clock_.meet(warp, members);
    }
    void fence();

    // Device memory comes from here: what is beside it and what was freed is never handed out
    // again.
    void* allocate(size_t bytes, size_t alignment, const Where& where); // null: no room
    void release(void* pointer, size_t bytes);
    void wrote(const void* pointer, size_t bytes); // by the runtime
    void copied(const CopyCall& call);
    void add_stack(const void* bottom, size_t bytes);
    Concurrency& concurrency() { return concurrency_; }

    // What the compiler's calls tell. `pc`: behind the access, in the student's code.
    void access(uintptr_t address, unsigned bytes, bool writes, Touch touch, Pc pc);
    // The running thread is about to look at the place again by an atomic operation that leaves it
    // as it is, unless it still must change.
    void checks_again(uintptr_t address);

    // Ends the launch, with cudaErrorIllegalAddress; does not come back.
    [[noreturn]] void stop_after(const Finding& finding);
    bool has_told(const std::string& report) const { return report == stopped_by_; }
    // Counts an access out of bounds; ends the launch after many, since a loop may run there for
    // ever.
    void count_out_of_bounds(const Finding& finding);

    bool in_kernel() const { return thread_ >= 0; }
    int thread() const { return thread_; } // that runs, by number
    bool prints() const { return prints_; }
    const Launch& launch() const { return *launch_; }

    // The allocation, freed ones included, in which the address lies or to which it is next.
    const Allocation* nearest(uintptr_t address) const;

  private:
    Watcher();
    void look(uintptr_t address, unsigned bytes, bool writes, Touch touch, Pc pc);
    Range* range_of(uintptr_t address);
    Span stack_of(uintptr_t address) const;
    void look_outside(uintptr_t address, bool writes, Pc pc);
    void look_at_depth() {
        const uintptr_t here = uintptr_t(__builtin_frame_address(0));
        if (!quiet_reads.shallow.has(here)) count_calls(here);
    }
    void count_calls(uintptr_t here);
    void set_stack(const Span& stack);
    void prepare_quiet_reads();
    void host_access(uintptr_t address, unsigned bytes, bool writes, Touch touch, Pc pc);
    void host_uses_symbol(uintptr_t address, unsigned bytes, bool writes, Pc pc);
    // Whom the word is quiet for from now on.
    enum class Quiet { nobody, thread, warp };
    void mark(Range& range, uintptr_t word, Quiet quiet);
    Quiet check(Range& range, Word& word, const Access& me, bool writes, uintptr_t address,
                unsigned bytes);
    bool is_current(const Range& range, const Access& access) const;
    bool insert_reader(const Range& range, Word& word, const Access& me);
    bool all_lanes_know(const Range& range, const Access& access) const;
    void conflict(const Range& range, const Access& before, bool before_wrote, const Access& me,
                  bool writes, uintptr_t address, unsigned bytes);

    bool has_read(uintptr_t address) const; // the running thread, shortly before
    void note_traffic();

    BlockClock clock_;
    RaceBook races_;
    Concurrency concurrency_{races_};
    const Launch* launch_ = nullptr;
    uint32_t launch_number_ = 0;
    int thread_ = -1;
    bool prints_ = true;
    // The watch is at work. The linker keeps one copy of a library's template, say of std::map, and
    // it may be the kernel's, which calls the watch: such calls are not the kernel's accesses.
    bool is_busy_ = false;
    std::string stopped_by_ = "nothing";        // the text of the finding
    int out_of_bounds_ = 0;                     // in this launch
    std::map<uint32_t, Finding> uninitialised_; // by site

    size_t used_;         // of the arena
    Range arena_;         // what allocate() gives
    Range symbols_;       // variables of the program
    ByteBits host_wrote_; // of these, since the runtime copied to them
    Pc* host_writers_;    // the last statement that did, by 64 bytes
    std::map<const void*, Range>
        statics_of_;           // static __shared__ variables, by &threadIdx of the worker
    Range* statics_ = nullptr; // of the worker that runs
    std::map<uintptr_t, Allocation> allocations_;
    std::map<uintptr_t, Range> dynamics_; // dynamic shared memory, by its first address
    Range* dynamic_ = nullptr;            // the block's
    bool counts_traffic_ = false;         // RAYLAB_COUNT=memory in the environment
    TrafficCounter traffic_;
    std::map<uintptr_t, size_t> stacks_;            // of CUDA threads: lowest address, bytes
    std::array<LastReads, 1024> last_reads_;        // by thread
    size_t stack_limit_ = 0, depth_to_look_at_ = 0; // bytes: cudaLimitStackSize, and here
};

} // namespace raylab::simt::watch
