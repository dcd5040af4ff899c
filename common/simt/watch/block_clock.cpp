#include "common/simt/watch/block_clock.h"

#include <algorithm>
#include <bit>

namespace raylab::simt::watch {

void BlockClock::begin_block(uint32_t block, int threads) {
    threads_ = threads;
    thread_bits_ = std::bit_width(unsigned(threads - 1));
    block_ = block & (~0u >> thread_bits_);
    epoch_ = 1; // 0: nobody knows it
    std::fill_n(now_.begin(), threads_, epoch_ << step_bits);
    if (lanes_met_) lane_ = {};
    lanes_met_ = false;
    block_knows_.clear();
    block_fenced_.clear();
    knows_.clear();
    fenced_.clear();
    if (next_stamp_ > no_stamp / 2) {
        next_stamp_ = 1;
        forgotten_ = true;
    }
    new_stamps();
}

unsigned BlockClock::existing(int warp) const {
    const int left = threads_ - warp * lanes;
    return left >= lanes ? ~0u : (1u << left) - 1;
}

void BlockClock::new_stamps() {
    for (int thread = 0; thread < threads_; ++thread) stamps_[thread] = next_stamp_++;
    for (int warp = 0; warp * lanes < threads_; ++warp) warp_stamps_[warp] = next_stamp_++;
}

bool BlockClock::knows(int thread, Task task, Time time) const {
    const uint32_t block = block_of(task);
    if (block == block_) {
        const int other = thread_of(task);
        if (other == thread || epoch_of(time) < epoch_) return true;
        if (other / lanes == thread / lanes && time <= lane_[thread][other % lanes]) return true;
    }
    if (block_knows_.knows(task, block, time)) return true;
    const auto mine = knows_.find(thread);
    return mine != knows_.end() && mine->second.knows(task, block, time);
}

void BlockClock::barrier() {
    for (const auto& [thread, knowledge] : knows_) block_knows_.learn(knowledge);
    knows_.clear();
    for (const auto& [thread, knowledge] : fenced_) block_fenced_.learn(knowledge);
    // Where every thread has fenced since the last barrier, the whole epoch may be published.
    if (int(fenced_.size()) == threads_) {
        block_fenced_.clear();
        block_fenced_.learn(block_knows_);
        block_fenced_.learn_block(block_, epoch_ + 1);
    }
    fenced_.clear();
    if (lanes_met_) std::fill_n(lane_.begin(), threads_, std::array<Time, lanes>{});
    lanes_met_ = false;
    ++epoch_;
    std::fill_n(now_.begin(), threads_, epoch_ << step_bits);
    new_stamps();
}

void BlockClock::meet(int warp, unsigned members) {
    lanes_met_ = true;
    std::array<Time, lanes> together{};
    Knowledge learnt;
    for (unsigned rest = members; rest; rest &= rest - 1) {
        const int lane = std::countr_zero(rest), thread = warp * lanes + lane;
        for (int l = 0; l < lanes; ++l)
            if (together[l] < lane_[thread][l]) together[l] = lane_[thread][l];
        if (together[lane] < now_[thread]) together[lane] = now_[thread];
        if (const auto found = knows_.find(thread); found != knows_.end())
            learnt.learn(found->second);
    }
    for (unsigned rest = members; rest; rest &= rest - 1) {
        const int thread = warp * lanes + std::countr_zero(rest);
        lane_[thread] = together;
        if (!learnt.is_empty()) knows_[thread] = learnt;
        step(thread);
    }
    warp_stamps_[warp] = members == existing(warp) ? next_stamp_++ : no_stamp;
}

void BlockClock::fence(int thread) {
    Knowledge& fenced = fenced_[thread];
    fenced.learn_block(block_, epoch_);
    fenced.learn_task(task(thread), now_[thread]);
    if (lanes_met_)
        for (int l = 0; l < lanes; ++l)
            if (const Time time = lane_[thread][l])
                fenced.learn_task(task(thread / lanes * lanes + l), time);
    fenced.learn(block_knows_);
    if (const auto found = knows_.find(thread); found != knows_.end()) fenced.learn(found->second);
    step(thread);
    warp_stamps_[thread / lanes] = no_stamp;
}

void BlockClock::publish(int thread, uintptr_t flag) {
    const auto found = fenced_.find(thread);
    if (found == fenced_.end() && block_fenced_.is_empty()) return;
    Knowledge& published = published_[flag];
    published.learn(block_fenced_);
    if (found != fenced_.end()) published.learn(found->second);
}

void BlockClock::pick_up(int thread, uintptr_t flag) {
    if (published_.empty()) return;
    const auto found = published_.find(flag);
    if (found == published_.end()) return;
    knows_[thread].learn(found->second);
    stamps_[thread] = next_stamp_++;
    warp_stamps_[thread / lanes] = no_stamp;
}

} // namespace raylab::simt::watch
