// The signal handler uses only what POSIX allows there: atomics, clock_gettime, unlink, kill,
// _exit.
#include "common/cli/interrupt.h"

#include "common/cli/leftovers.h"

#include <atomic>
#include <csignal>
#include <cstdint>
#include <ctime>
#include <future>
#include <thread>
#include <unistd.h>

namespace raylab {

namespace {

std::atomic<int> keepers{0};
std::atomic<int> first_signal{0};
std::atomic<std::int64_t> first_milliseconds{0};
static_assert(std::atomic<std::int64_t>::is_always_lock_free);

constexpr int same_press_milliseconds = 300;

std::int64_t milliseconds() {
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return std::int64_t{1000} * now.tv_sec + now.tv_nsec / 1000000;
}

extern "C" void on_signal(int signal) {
    if (keepers > 0) {
        int none = 0;
        if (first_signal.compare_exchange_strong(none, signal)) {
            first_milliseconds = milliseconds();
            return;
        }
        const std::int64_t first = first_milliseconds; // 0: another thread is just setting it
        if (first == 0 || milliseconds() - first < same_press_milliseconds) return;
    }
    end_without_leftovers(128 + signal);
}

} // namespace

void catch_signals() {
    struct sigaction action {};
    action.sa_handler = on_signal;
    action.sa_flags = SA_RESTART;
    sigemptyset(&action.sa_mask);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction before {};
        sigaction(signal, nullptr, &before);
        if (before.sa_handler != SIG_IGN) sigaction(signal, &action, nullptr);
    }
    std::signal(SIGXFSZ, SIG_IGN);
}

KeepsWork::KeepsWork() { ++keepers; }
KeepsWork::~KeepsWork() { --keepers; }

int interrupted() { return first_signal; }

bool run_interruptibly(const std::function<void()>& work, const std::function<void()>& tick,
                       double grace_seconds) {
    std::packaged_task<void()> task(work);
    std::future<void> end = task.get_future();
    std::thread thread(std::move(task));
    using std::chrono::milliseconds, std::chrono::duration;
    while (!interrupted() && end.wait_for(milliseconds(20)) != std::future_status::ready)
        if (tick) tick();
    if (end.wait_for(duration<double>(grace_seconds)) != std::future_status::ready) {
        thread.detach();
        return false;
    }
    thread.join();
    end.get();
    return true;
}

} // namespace raylab
