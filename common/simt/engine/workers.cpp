// The workers; see workers.h.
#include "common/simt/engine/workers.h"

#include <algorithm>
#include <numeric>

namespace raylab::simt {

// One launch, shared by the workers.
struct Workers::Job {
    Job(const Work& work, const Options& options, int workers)
        : work(work), grid(work.launch.grid), blocks(uint64_t(grid.x) * grid.y * grid.z),
          // Enough chunks for a good balance, and few enough that taking one costs nothing.
          chunk(std::max<uint64_t>(1, blocks / (uint64_t(workers) * 64))), order(options.order) {
        if (order != Order::random) return;
        // x -> (stride x + offset) mod blocks visits every block once if stride and blocks have no
        // common factor.
        std::mt19937_64 random(options.seed);
        offset = random() % blocks;
        do stride = random() % blocks + (blocks == 1);
        while (std::gcd(stride, blocks) != 1);
    }

    // The block that has the given place in the order.
    uint3 block(uint64_t turn) const {
        uint64_t b = turn;
        if (order == Order::reverse) b = blocks - 1 - turn;
        if (order == Order::random)
            b = uint64_t(((unsigned __int128)stride * turn + offset) % blocks);
        return {unsigned(b % grid.x), unsigned(b / grid.x % grid.y), unsigned(b / grid.x / grid.y)};
    }

    const Work& work;
    dim3 grid;
    uint64_t blocks, chunk, stride = 1, offset = 0;
    Order order;
    std::atomic<uint64_t> next{0};
    std::atomic<bool> failed{false};
    std::mutex mutex;
    KernelFault fault;
};

Workers::Workers(const Options& options, int count) : options_(options) {
    for (int worker = 0; worker < count; ++worker)
        blocks_.push_back(std::make_unique<Block>(options));
    for (int worker = 1; worker < count; ++worker)
        threads_.emplace_back([this, worker] { serve(worker); });
}

Workers::~Workers() {
    quit_ = true;
    ++generation_;
    generation_.notify_all();
    for (auto& thread : threads_) thread.join();
}

static void pause() {
#if defined(__x86_64__)
    __builtin_ia32_pause();
#elif defined(__aarch64__)
    asm volatile("yield");
#endif
}

// Waits until `value` is no longer `old`. Launches often follow each other closely: look around for
// some microseconds before going to sleep.
template <class T> static T wait_for_change(const std::atomic<T>& value, T old) {
    for (int i = 0; i < 1000; ++i) {
        if (T now = value.load(std::memory_order_acquire); now != old) return now;
        pause();
    }
    value.wait(old);
    return value.load();
}

void Workers::serve(int worker) {
    for (uint32_t seen = 0;;) {
        seen = wait_for_change(generation_, seen);
        if (quit_) return;
        ++active_;
        if (open_) take_part(*blocks_[size_t(worker)], *job_);
        if (--active_ == 0) active_.notify_one();
    }
}

void Workers::take_part(Block& block, Job& job) {
    expect_faults();
    for (;;) {
        uint64_t first = job.next.fetch_add(job.chunk, std::memory_order_relaxed);
        uint64_t last = std::min(first + job.chunk, job.blocks);
        if (first >= job.blocks) return;
        for (uint64_t turn = first; turn < last; ++turn) {
            if (job.failed.load(std::memory_order_relaxed)) return;
            if (block.run(job.work, job.block(turn))) continue;
            std::lock_guard lock(job.mutex);
            if (!job.failed.exchange(true)) job.fault = {block.fault_code(), block.fault()};
        }
    }
}

#if defined(RAYLAB_CHECK_THREAD)

// Each block on an operating system thread of its own: its __shared__ variables are then fresh
// memory for ThreadSanitizer, and what different blocks do is not in any order. To announce a CUDA
// thread takes 0.6 ms, so the first ones are kept for the next launch, which comes after this one
// in any case.
Workers::KernelFault Workers::run(const Work& work) {
    constexpr size_t most_kept = 4096; // CUDA threads; ThreadSanitizer ends at 8128
    const dim3& shape = work.launch.block;
    size_t block_threads = size_t(shape.x) * shape.y * shape.z;
    Job job(work, options_, 1);
    Unobserved freeing; // of what CUDA threads used
    if (!blocks_.empty() && blocks_[0]->threads() != block_threads) blocks_.clear();
    for (uint64_t turn = 0; turn < job.blocks && !job.failed; ++turn) {
        bool known = turn < blocks_.size();
        auto block = known ? std::move(blocks_[turn]) : std::make_unique<Block>(options_);
        std::thread([&] {
            expect_faults();
            job.failed = !block->run(work, job.block(turn));
        }).join();
        if (job.failed) {
            job.fault = {block->fault_code(), block->fault()};
            blocks_.clear();
        } else if (known) {
            blocks_[turn] = std::move(block);
        } else if ((turn + 1) * block_threads <= most_kept) {
            blocks_.push_back(std::move(block));
        }
    }
    return job.fault;
}

#else

Workers::KernelFault Workers::run(const Work& work) {
    Job job(work, options_, int(blocks_.size()));
    if (job.blocks == 1 || threads_.empty()) {
        take_part(*blocks_[0], job);
        return job.fault;
    }
    job_ = &job;
    open_ = true;
    ++generation_;
    generation_.notify_all();
    take_part(*blocks_[0], job);
    open_ = false;
    while (int active = active_) wait_for_change(active_, active);
    return job.fault;
}

#endif

} // namespace raylab::simt
