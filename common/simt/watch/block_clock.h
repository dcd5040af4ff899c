// The clocks of the threads of the block that runs (knowledge.h).
#pragma once

#include "common/simt/watch/knowledge.h"

#include <array>
#include <unordered_map>
#include <utility>

namespace raylab::simt::watch {

class BlockClock {
  public:
    void begin_launch() { published_.clear(); }
    void begin_block(uint32_t block, int threads);

    Task task(int thread) const { return block_ << thread_bits_ | Task(thread); }
    uint32_t block_of(Task task) const { return task >> thread_bits_; }
    int thread_of(Task task) const { return int(task & ((1u << thread_bits_) - 1)); }
    uint32_t block() const { return block_; }
    Time now(int thread) const { return now_[thread]; }

    // Nobody has had the same before (but after forgotten()).
    Stamp stamp(int thread) const { return stamps_[thread]; }
    // None while some lanes of the warp know what others do not.
    Stamp warp_stamp(int thread) const { return warp_stamps_[thread / lanes]; }
    // Whether stamps begin anew: those of earlier blocks must be forgotten.
    bool forgotten() { return std::exchange(forgotten_, false); }

    // Whether `thread` of this block knows what `task` did at `time` of the same launch.
    bool knows(int thread, Task task, Time time) const;

    void barrier();                           // all threads of the block have met
    void meet(int warp, unsigned members);    // these lanes have
    void fence(int thread);                   // what the thread knows may be published from here on
    void publish(int thread, uintptr_t flag); // an atomic or volatile write
    void pick_up(int thread, uintptr_t flag); // an atomic or volatile read

  private:
    static constexpr int lanes = 32, most_threads = 1024;

    void step(int thread) {
        now_[thread] += (now_[thread] & last_step) != last_step;
        stamps_[thread] = next_stamp_++;
    }
    unsigned existing(int warp) const; // lanes of the warp
    void new_stamps();

    uint32_t block_ = 0, epoch_ = 0;
    int threads_ = 1, thread_bits_ = 0;
    std::array<Time, most_threads> now_{};
    // lane_[t][l]: up to which time thread t knows lane l of its warp.
    std::array<std::array<Time, lanes>, most_threads> lane_{};
    bool lanes_met_ = false; // since the last barrier
    std::array<Stamp, most_threads> stamps_{};
    std::array<Stamp, most_threads / lanes> warp_stamps_{};
    Stamp next_stamp_ = 1; // 0: the mark of a word that nobody has looked at
    bool forgotten_ = false;

    Knowledge block_knows_, block_fenced_;               // all threads of the block
    std::unordered_map<int, Knowledge> knows_, fenced_;  // one of them
    std::unordered_map<uintptr_t, Knowledge> published_; // at a flag
};

} // namespace raylab::simt::watch
