// The watchdog; see watchdog.h.
//
// A thread of its own looks at the clock. When the time is up it sends a signal to the worker,
// whose handler writes down where it was and then stands still, so that the report can be made in
// peace. ThreadSanitizer may hold the signal back; then the report names the launch instead.
#include "common/simt/engine/watchdog.h"

#include "common/simt/engine/block.h"
#include "common/simt/engine/findings.h"
#include "common/simt/engine/interrupted.h"
#include "common/simt/engine/machine.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <thread>
#include <unistd.h>
#include <vector>

namespace raylab::simt {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int interrupting = SIGUSR2;

struct Watchdog {
    std::mutex mutex;
    std::vector<Block*> blocks;
    bool running = false; // a launch, since:
    Clock::time_point since;

    std::atomic<bool> is_known{false};
    Fault where; // the interrupted thread is, once that is known
};

// Never destroyed: its thread looks at it to the end.
Watchdog& watchdog() {
    static auto* watchdog = new Watchdog;
    return *watchdog;
}

void stand_still(int signal, siginfo_t* information, void* context) {
    watchdog().where = interrupted(signal, information, context);
    watchdog().is_known = true;
    for (;;) pause();
}

// Holds the mutex: no block comes or goes.
[[noreturn]] void end_program(double seconds) {
    for (Block* block : watchdog().blocks) {
        if (!block->interrupt(interrupting)) continue;
        for (int i = 0; i < 200 && !watchdog().is_known; ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        remember_fault(cudaErrorLaunchFailure, block->still_running(watchdog().where, seconds));
        break;
    }
    write_summary();
    if (ftrylockfile(stdout) == 0) std::fflush(stdout); // unless the kernel is in a printf()
    std::_Exit(1);
}

[[noreturn]] void look_at_the_clock(double limit) {
    for (;;) {
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        std::lock_guard lock(watchdog().mutex);
        if (!watchdog().running) continue;
        const double seconds =
            std::chrono::duration<double>(Clock::now() - watchdog().since).count();
        if (seconds > limit) end_program(seconds);
    }
}

// Starts the thread, at the first launch.
bool has_limit() {
    static const bool has = [] {
        const char* text = std::getenv("RAYLAB_TIME_LIMIT");
        const double limit = text ? std::atof(text) : 0;
        if (limit <= 0) return false;
        struct sigaction action {};
        action.sa_sigaction = stand_still;
        action.sa_flags = SA_SIGINFO | SA_ONSTACK;
        sigemptyset(&action.sa_mask);
        sigaction(interrupting, &action, nullptr);
        std::thread(look_at_the_clock, limit).detach();
        return true;
    }();
    return has;
}

} // namespace

void enrol(Block& block) {
    std::lock_guard lock(watchdog().mutex);
    watchdog().blocks.push_back(&block);
}

void strike_off(Block& block) {
    std::lock_guard lock(watchdog().mutex);
    std::erase(watchdog().blocks, &block);
}

TimedLaunch::TimedLaunch() {
    if (!has_limit()) return;
    std::lock_guard lock(watchdog().mutex);
    watchdog().running = true;
    watchdog().since = Clock::now();
}

TimedLaunch::~TimedLaunch() {
    if (!has_limit()) return;
    std::lock_guard lock(watchdog().mutex);
    watchdog().running = false;
}

} // namespace raylab::simt
