// Who has seen what: the order between CUDA threads that barriers, fences and atomics make.
//
// The time of a thread is its block's epoch, the barriers passed, and a step within the epoch. An
// access happens before another if the second thread knows the first one's time (Lamport 1978). Of
// its own block a thread knows all earlier epochs, of its warp what __syncwarp() and its kin told
// it. Of other blocks it knows only what a fence published and an atomic or volatile access picked
// up; that is rare, so it is kept in maps.
#pragma once

#include <cstddef>
#include <cstdint>
#include <unordered_map>

namespace raylab::simt::watch {

using Task = uint32_t; // a CUDA thread of the launch: its block's number, then its own (BlockClock)
using Time = uint32_t; // epoch << step_bits | step

// A number that a thread, or a warp, has as long as nothing new is known (quiet_reads.h).
using Stamp = uint32_t;
inline constexpr Stamp no_stamp = ~Stamp(0);

inline constexpr int step_bits = 12;
inline constexpr Time last_step = (1u << step_bits) - 1;
constexpr uint32_t epoch_of(Time time) { return time >> step_bits; }

// What is known of threads of other blocks, or is handed to them.
class Knowledge {
  public:
    void learn_block(uint32_t block, uint32_t epochs) { raise(blocks_, block, epochs); }
    void learn_task(Task task, Time time) { raise(tasks_, task, time); }
    void learn(const Knowledge& other);

    bool knows(Task task, uint32_t block, Time time) const;
    bool is_empty() const { return !all_ && blocks_.empty() && tasks_.empty(); }
    void clear() { *this = {}; }

  private:
    // Beyond this many entries it counts as knowing everything: a race may be missed, none
    // invented.
    static constexpr size_t most = 4096;

    template <class Map> void raise(Map& map, uint32_t key, uint32_t value) {
        if (all_) return;
        uint32_t& known = map[key];
        if (known < value) known = value;
        if (map.size() > most) all_ = true;
    }

    std::unordered_map<uint32_t, uint32_t> blocks_; // block: its epochs below this one
    std::unordered_map<Task, Time> tasks_;          // thread: its accesses up to this time
    bool all_ = false;
};

} // namespace raylab::simt::watch
