// Stage 6: "remove terminated rays from the ray pool through string compaction type process".
//
//     live    3 7 2 9 4      slots
//     keep    1 0 1 1 0      1: that slot's path is alive
//     place   0 1 1 2 3      exclusive scan of keep: how many are kept before
//     result  3 2 9          each kept slot at its place
// Stable: slots keep their order, so neighbours in the image stay neighbours in a warp. Four bytes
// a path are moved; the path itself stays in its slot. GPU Gems 3, 39.3.1.
#pragma once

#include "common/device/device_array.h"
#include "labs/03_wavefront/queues.h"
#include "labs/03_wavefront/scan.h"

namespace raylab::lab03 {

class Compaction {
  public:
    // capacity: of the longest list.
    Compaction(ScanKind scan, int capacity, int block_size);

    // Numbers of device memory that it needs for each of `capacity` slots, at most.
    static std::int64_t words(ScanKind scan, std::int64_t capacity);

    // Writes the slots of live[0 ... n) that are alive to `kept`; returns how many.
    int keep_alive(const std::uint8_t* alive, const int* live, int n, int* kept);

    // Writes first those of the n slots whose bit is clear, then those whose bit is set, each group
    // in its order: one step of a radix sort. key: of each slot.
    void split_by_bit(const std::uint8_t* key, int bit, const int* slots, int n, int* result);

    // How many of live[0 ... n) are alive, and how many warps hold one, added to the counters: for
    // lists that stay as they are.
    void count_alive(const std::uint8_t* alive, const int* live, int n, Counters* counters);

  private:
    int scan_flags(int n); // flags_ -> places_; returns the sum of flags_

    ScanFunction* scan_;
    int block_;
    DeviceArray<std::uint32_t> flags_, places_, workspace_;
};

} // namespace raylab::lab03
