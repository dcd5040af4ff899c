// The clocks of the threads of the block that runs (knowledge.h).
#pragma once

#include "common/simt/watch/knowledge.h"

#include <array>
#include <unordered_map>
#include <vector>

namespace raylab::simt::watch {

class BlockClock {
  public:
    void begin_launch() { published_.clear(); }
    void begin_block(uint32_t block, int threads);

    Task task(int thread) const { return block_ * uint32_t(threads_) + Task(thread); }
    uint32_t block_of(Task task) const { return task / uint32_t(threads_); }
    int thread_of(Task task) const { return int(task % uint32_t(threads_)); }
    uint32_t block() const { return block_; }
    Time now(int thread) const { return now_[thread]; }

    // Whether `thread` of this block knows what `task` did at `time` of the same launch.
    bool knows(int thread, Task task, Time time) const;

    void barrier();                           // all threads of the block have met
    void meet(int warp, unsigned members);    // these lanes have
    void fence(int thread);                   // what the thread knows may be published from here on
    void publish(int thread, uintptr_t flag); // an atomic or volatile write
    void pick_up(int thread, uintptr_t flag); // an atomic or volatile read

  private:
    static constexpr int lanes = 32, most_threads = 1024;

    void step(int thread) { now_[thread] += (now_[thread] & last_step) != last_step; }

    uint32_t block_ = 0, epoch_ = 0;
    int threads_ = 1;
    std::array<Time, most_threads> now_{};
    // lane_[t][l]: up to which time thread t knows lane l of its warp.
    std::array<std::array<Time, lanes>, most_threads> lane_{};
    bool lanes_met_ = false; // since the last barrier

    Knowledge block_knows_, block_fenced_;               // all threads of the block
    std::unordered_map<int, Knowledge> knows_, fenced_;  // one of them
    std::unordered_map<uintptr_t, Knowledge> published_; // at a flag
};

} // namespace raylab::simt::watch
