// The scheduler of one block; see block.h.
#include "common/simt/engine/block.h"

#include "common/simt/collectives.h"
#include "common/simt/engine/report.h"
#include "common/simt/engine/switch.h"
#include "common/simt/engine/watchdog.h"
#include "common/simt/watch/events.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <numeric>

namespace raylab::simt {

constinit thread_local Block* current_block = nullptr;

Block::Block(const Options& options) : options_(options), fibers_(options.stack_size) {
    enrol(*this);
}

Block::~Block() { strike_off(*this); }

bool Block::run(const Work& work, uint3 index) {
    begin(work, index);
    if (!fault_.empty()) return false;
    home_ = native_fiber();
    announce_release(&begun_);
    if (one_stack_per_thread) fibers_.reclaim();
    if (one_stack_per_thread && !fibers_.reserve(size_t(count_))) {
        fault_ = Report(*this).no_stacks();
        return false;
    }
    Block* outer = std::exchange(current_block, this);
    current_ = fibers_.take();
    runs_on_ = pthread_self();
    is_running_ = true;
    if (current_)
        switch_fiber(home_, *current_);
    else
        fault_ = Report(*this).no_stacks();
    is_running_ = false;
    current_block = outer;
    watch::pause();
    if (crash_.signal != 0) fault_ = Report(*this).crashed(crash_);
    if (fault_.empty()) return true;
    fibers_.reclaim();
    return false;
}

void Block::begin(const Work& work, uint3 index) {
    work_ = &work;
    blockIdx = index;
    blockDim = work.launch.block;
    gridDim = work.launch.grid;
    if (blockDim.x != shape_.x || blockDim.y != shape_.y || blockDim.z != shape_.z) {
        shape_ = blockDim;
        count_ = 0;
        for (unsigned z = 0; z < shape_.z; ++z)
            for (unsigned y = 0; y < shape_.y; ++y)
                for (unsigned x = 0; x < shape_.x; ++x) index_[count_++] = {x, y, z};
        std::iota(order_.begin(), order_.begin() + count_, 0);
        if (options_.order == Order::reverse) std::reverse(order_.begin(), order_.begin() + count_);
    }
    if (options_.order == Order::random) {
        uint64_t number = (uint64_t(index.z) * gridDim.y + index.y) * gridDim.x + index.x;
        random_.seed(unsigned(options_.seed * 0x9e3779b97f4a7c15u + number));
        std::shuffle(order_.begin(), order_.begin() + count_, random_);
    }
    std::memset(status_.data(), int(Status::fresh), size_t(count_));
    started_ = waiting_ = first_ready_ = ready_count_ = arrived_ = votes_ = 0;
    same_site_ = true;
    in_operation_.fill(0);
    converging_.fill(0);
    fault_.clear();
    fault_code_ = cudaErrorLaunchFailure;
    crash_.signal = 0;
    if (!shared_.resize(work.launch.shared_bytes)) fault_ = Report(*this).no_stacks();
    watch::begin_block(uint32_t((index.z * gridDim.y + index.y) * gridDim.x + index.x), count_,
                       shared_.data(), work.launch.shared_bytes);
}

void Block::stack_main() {
    Fiber* const self = current_;
    enter_fiber();
    for (;;) {
        int thread = order_[started_++];
        go_on(thread);
        announce_acquire(&begun_);
        if (one_stack_per_thread) announce_name(self->announced, Report(*this).running().c_str());
        work_->thread_main(work_->arguments);
        watch::pause();
        status_[thread] = Status::ended;
        announce_release(work_->finished);
        if (!one_stack_per_thread && ready_count_ == 0 && started_ < count_) continue;

        Fiber* next = next_fiber();
        if (!one_stack_per_thread) fibers_.give(self);
        switch_fiber(*self, *next, true);
    }
}

void Block::go_on(int thread) {
    running_ = thread;
    status_[thread] = Status::running;
    watch::go_on(thread);
    threadIdx = index_[thread];
}

// The one that runs next: a thread that is ready, else the next one to start, else, when all are
// done or no one can go on, home.
Fiber* Block::next_fiber() {
    if (ready_count_ == 0 && started_ == count_ && !release_converged() && !release_whole_warps()) {
        if (waiting_ > 0) fault_ = Report(*this).stuck();
        return &home_;
    }
    if (ready_count_ > 0) {
        int thread = ready_[first_ready_];
        first_ready_ = (first_ready_ + 1) % max_threads;
        --ready_count_;
        go_on(thread);
        return current_ = waiters_[thread].fiber;
    }
    if (Fiber* fresh = fibers_.take()) return current_ = fresh;
    fault_ = Report(*this).no_stacks();
    return &home_;
}

// Lets the others run until the running thread is ready again.
void Block::suspend() {
    Fiber* self = current_;
    Fiber* next = next_fiber();
    if (next != self) switch_fiber(*self, *next);
}

void Block::arrive(Wait kind, const Site& site) {
    Waiter& waiter = waiters_[running_];
    waiter.fiber = current_;
    waiter.site = &site;
    waiter.kind = kind;
    watch::pause();
    status_[running_] = Status::waiting;
    ++waiting_;
    announce_release(work_->finished); // after a fault the thread never comes back
}

// Appends threads to those that are ready, in this order, or in any order if it is to be random.
void Block::make_ready(uint16_t* threads, int count) {
    if (options_.order == Order::random) std::shuffle(threads, threads + count, random_);
    for (int i = 0; i < count; ++i)
        ready_[(first_ready_ + ready_count_++) % max_threads] = threads[i];
    waiting_ -= count;
}

int Block::sync_block(const Site& site, int predicate) {
    void* meeting = block_meeting_.now();
    announce_release(meeting);
    arrive(Wait::block, site);
    same_site_ &= arrived_ == 0 || waiters_[arrivals_[0]].site == &site;
    votes_ += predicate;
    arrivals_[arrived_++] = uint16_t(running_);
    if (arrived_ == count_ && same_site_) open_barrier();
    suspend();
    announce_acquire(meeting);
    // The next barrier cannot complete, and change it, before this thread arrives there.
    return result_;
}

// Since Volta a barrier waits only for threads that have not returned. Where whole warps have, the
// others go on; a warp of which some lanes wait and some have returned is stopped, for it is almost
// always a mistake.
bool Block::release_whole_warps() {
    if (arrived_ == 0 || arrived_ != waiting_ || !same_site_ || options_.strict_barriers)
        return false;
    for (int warp = 0; warp * lanes < count_; ++warp) {
        int ended = 0;
        for (int lane = 0; lane < lanes && warp * lanes + lane < count_; ++lane)
            ended += status_[warp * lanes + lane] == Status::ended;
        if (ended != 0 && ended != std::min(lanes, count_ - warp * lanes)) return false;
    }
    open_barrier();
    return true;
}

// All who must come have come.
void Block::open_barrier() {
    result_ = std::exchange(votes_, 0);
    watch::barrier();
    make_ready(arrivals_.data(), std::exchange(arrived_, 0));
    block_meeting_.turn ^= 1;
}

void Block::give_up(std::string fault, cudaError_t code) {
    fault_ = std::move(fault);
    fault_code_ = code;
    watch::pause();
    announce_release(work_->finished);
    switch_fiber(*current_, home_, true);
    __builtin_unreachable();
}

} // namespace raylab::simt

extern "C" void raylab_simt_main() { raylab::simt::current_block->stack_main(); }
