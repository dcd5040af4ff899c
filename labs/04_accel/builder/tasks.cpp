#include "labs/04_accel/builder/tasks.h"

#include "common/cli/joined_threads.h"

#include <thread>

namespace raylab::lab04 {

void BuildTasks::add(std::size_t size, std::function<void()> work) {
    const std::lock_guard lock(mutex_);
    if (failure_) return;
    waiting_.push_back({size, std::move(work)});
    std::push_heap(waiting_.begin(), waiting_.end());
    changed_.notify_one();
}

void BuildTasks::run(int threads) {
    {
        JoinedThreads others;
        for (int i = 1; i < threads; ++i) others.start([this] { take_part(); });
        take_part();
    }
    if (failure_) std::rethrow_exception(failure_);
}

// Until nothing waits, and nobody runs who might add to it.
void BuildTasks::take_part() {
    std::unique_lock lock(mutex_);
    for (;;) {
        changed_.wait(lock, [this] { return !waiting_.empty() || running_ == 0; });
        if (waiting_.empty()) return;
        std::pop_heap(waiting_.begin(), waiting_.end());
        const Task task = std::move(waiting_.back());
        waiting_.pop_back();
        ++running_;
        lock.unlock();
        std::exception_ptr failure;
        try {
            task.work();
        } catch (...) {
            failure = std::current_exception();
        }
        lock.lock();
        --running_;
        if (failure && !failure_) {
            failure_ = failure;
            waiting_.clear();
        }
        if (running_ == 0) changed_.notify_all();
    }
}

int threads_or_cores(int threads) {
    return threads > 0 ? threads
                       : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

} // namespace raylab::lab04
