// Compaction, as lab 03 writes it: the slots that are alive move up in the list, in their order.
#pragma once

#include "common/device/device_array.h"

#include <cstdint>

namespace raylab {

class Compaction {
  public:
    // capacity: of the longest list.
    Compaction(int capacity, int block_size);

    // Numbers of device memory that it needs for `capacity` slots.
    static std::int64_t words(std::int64_t capacity);

    // Writes the slots of live[0 ... n) that are alive to `kept`; returns how many.
    int keep_alive(const std::uint8_t* alive, const int* live, int n, int* kept);

  private:
    int block_;
    DeviceArray<std::uint32_t> flags_, places_, workspace_;
};

} // namespace raylab
