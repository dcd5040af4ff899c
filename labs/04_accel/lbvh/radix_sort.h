// Sorting numbers by their digits, the lowest first; stable.
#pragma once

#include "common/device/device_array.h"

#include <cstdint>

namespace raylab::lab04 {

// Sorts the keys, of which only the lowest `bits` may be set, and moves the values along.
void radix_sort(DeviceArray<std::uint32_t>& keys, DeviceArray<int>& values, int bits);

} // namespace raylab::lab04
