// One block of CUDA threads on one worker: which threads have run, and which wait for which.
//
// The threads of a block run in a loop on one stack. A kernel without barriers is nothing but that
// loop. The first thread that must wait keeps the stack as its fiber, and the loop goes on, on a
// fresh stack, with the next thread. When the last one arrives at the barrier, all are ready again
// and get their turns in the same order. A thread that has ended lets its stack go.
#pragma once

#include "common/simt/engine/faults.h"
#include "common/simt/engine/fiber.h"
#include "common/simt/engine/shared_memory.h"
#include "common/simt/finding.h"
#include "common/simt/launch.h"
#include "common/simt/options.h"
#include "common/simt/runtime_errors.h"
#include "common/simt/site.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <pthread.h>
#include <random>
#include <string>
#include <vector>

namespace raylab::simt {

inline constexpr int max_threads = 1024, lanes = 32, max_warps = max_threads / lanes;

// A launch as a worker sees it.
struct Work {
    const Launch& launch;
    void (*thread_main)(const void*);
    const void* arguments;
    char* finished; // for ThreadSanitizer: where every CUDA thread ends up
};

// What a thread waits for.
enum class Wait { block, warp, vote, shuffle, converge, gather };

class Block {
  public:
    explicit Block(const Options& options);
    ~Block();
    Block(const Block&) = delete;
    Block& operator=(const Block&) = delete;

    // Runs the block with the given index. Returns false on a fault, which fault() then explains.
    bool run(const Work& work, uint3 index);
    const std::string& fault() const { return fault_; }
    cudaError_t fault_code() const { return fault_code_; }

    // The operations of collectives.h, for the thread that is running.
    int sync_block(const Site& site, int predicate);
    uint64_t warp_operation(Wait kind, const Site& site, unsigned mask, uint64_t value, int source);
    void gather(const Site& site, unsigned mask, uint64_t value, uint64_t* all);
    unsigned active_mask(const Site& site);
    [[noreturn]] void trap(const Site& site);
    [[noreturn]] void give_up(std::string fault, cudaError_t code = cudaErrorLaunchFailure);

    // For a handler of signals, and for assert(): the running thread does not go on.
    [[noreturn]] void crash(const Fault& fault);
    [[noreturn]] void fail_assertion(const char* condition, const char* file, int line);
    [[noreturn]] void overwrite(const void* end_of_function);

    // Ends the launch: what is wrong at this place, and what to do about it.
    [[noreturn]] void fail(const Site& site, const char* what, const char* to_do);

    void* shared() { return shared_.data(); }
    size_t shared_bytes() const { return shared_.bytes(); }

    // For the watchdog, which is another thread: sends the signal to the thread that runs the
    // block, if one does; and says where the CUDA thread is that has run for so long.
    bool interrupt(int signal);
    std::string still_running(const Fault& fault, double seconds) const;

    // Of the latest run.
    size_t threads() const { return size_t(count_); }

    // "thread (3,0,0) of block (0,0,0) of kernel k", for reports of others.
    std::string running() const;
    Actor actor() const;

    // The life of a stack; never returns.
    [[noreturn]] void stack_main();

  private:
    friend class Report;

    // A thread that waits: for what, where, and what it brought.
    struct Waiter {
        Fiber* fiber;
        const Site* site;
        Wait kind;
        int source;
        unsigned mask;
        uint64_t value; // in: brought, out: received
        uint64_t* all;  // out: what each lane brought
    };
    // Whether two lanes that wait, wait for each other. Where __syncwarp() stands does not matter,
    // but values are exchanged at one place only.
    static bool meet(const Waiter& a, const Waiter& b) {
        return a.kind == b.kind && a.mask == b.mask && (a.kind == Wait::warp || a.site == b.site);
    }

    enum class Status : uint8_t { fresh, running, waiting, ended };

    void begin(const Work& work, uint3 index);
    void suspend();
    Fiber* next_fiber();
    void arrive(Wait kind, const Site& site);
    void make_ready(uint16_t* threads, int count);
    bool agree(int warp, unsigned members) const;
    void complete(int warp, unsigned members);
    void warn_once(int thread) const;
    bool release_converged();
    bool release_whole_warps();
    void open_barrier();
    void go_on(int thread);
    unsigned existing(int warp) const;
    bool is_stack_overflow(const void* address) const;

    Options options_;
    std::minstd_rand random_;
    FiberPool fibers_;
    Fiber home_;
    Fiber* current_ = nullptr;
    const Work* work_ = nullptr;
    std::atomic<bool> is_running_{false};
    pthread_t runs_on_{};
    std::string fault_;
    cudaError_t fault_code_ = cudaErrorLaunchFailure;
    Fault crash_; // a signal's, until it is explained

    // Threads by number (x first, then y, then z), and the order in which they start.
    int count_ = 0, started_ = 0, running_ = 0, waiting_ = 0;
    dim3 shape_{0, 0, 0};
    std::array<uint3, max_threads> index_;
    std::array<uint16_t, max_threads> order_;
    std::array<Status, max_threads> status_;
    std::array<Waiter, max_threads> waiters_;

    // Threads that may go on, in this order: a ring, no thread is in it twice.
    std::array<uint16_t, max_threads> ready_;
    int first_ready_ = 0, ready_count_ = 0;

    // The block's barrier.
    std::array<uint16_t, max_threads> arrivals_;
    int arrived_ = 0, votes_ = 0, result_ = 0;
    bool same_site_ = true;

    // The lanes of each warp that wait for others of the warp, or to know who is with them.
    std::array<unsigned, max_warps> in_operation_;
    std::array<unsigned, max_warps> converging_;

    SharedMemory shared_; // dynamic

    // What ThreadSanitizer is told to have met. They alternate, so that a late leaver does not see
    // those who are already at the next barrier.
    struct Meeting {
        uint64_t points[2];
        int turn;
        void* now() { return &points[turn]; }
    };
    uint64_t begun_ = 0; // the launch, and the block before its first thread
    Meeting block_meeting_{};
    std::array<Meeting, max_threads> warp_meetings_{}; // by the first thread concerned
};

// The block that the calling worker runs, or null.
extern constinit thread_local Block* current_block;

} // namespace raylab::simt
