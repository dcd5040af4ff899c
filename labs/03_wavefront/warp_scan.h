// A scan within a warp: Hillis and Steele's over 32 lanes, where five rounds without barriers or
// memory beat any tree. Harris, CUDA Pro Tip: warp shuffles, 2014.
#pragma once

#include "common/simt/cuda.h"
#include "common/task/not_implemented.h"

#include <cstdint>

namespace raylab::lab03 {

constexpr unsigned all_lanes = 0xffffffffu;

// The sum over the lanes up to and with this one. All lanes of the warp must call it.
__device__ inline std::uint32_t warp_inclusive_scan(std::uint32_t value) {
    // Steps:
    // 1. Which lane of its warp is this thread?
    // 2. With distances 1, 2, 4, 8, 16: all lanes shuffle; each gets the value `distance` lanes
    //    before.
    // 3. Lanes that have no such lane keep theirs, the others add what they got.
    //[ task 3.2
    const int lane = static_cast<int>(threadIdx.x) % 32;
    for (int distance = 1; distance < 32; distance *= 2) {
        const std::uint32_t before = __shfl_up_sync(all_lanes, value, distance);
        if (lane >= distance) value += before;
    }
    //| not_implemented("3.2", "warp_inclusive_scan()");
    //]
    return value;
}

} // namespace raylab::lab03
