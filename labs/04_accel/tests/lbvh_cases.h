// What the tests of tasks 4.4 to 4.6 share: codes by definition, and a tree that was built.
#pragma once

#include "labs/04_accel/lbvh/build.h"
#include "labs/04_accel/lbvh/morton.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace raylab::lab04 {

// The code of a cell, bit by bit.
inline std::uint32_t code_of_cells(int x, int y, int z) {
    std::uint32_t code = 0;
    for (int bit = 0; bit < morton_bits; ++bit)
        code |= (x >> bit & 1) << (3 * bit + 2) | (y >> bit & 1) << (3 * bit + 1) |
                (z >> bit & 1) << 3 * bit;
    return code;
}

inline std::uint32_t code_by_definition(const Vec3& p, const Bounds& box) {
    int cell[3];
    for (int axis = 0; axis < 3; ++axis)
        cell[axis] = std::clamp(
            int((p[axis] - box.low[axis]) / (box.high[axis] - box.low[axis]) * 1024), 0, 1023);
    return code_of_cells(cell[0], cell[1], cell[2]);
}

inline BvhTree build_from_codes(const std::vector<Triangle>& triangles) {
    const DeviceArray<Triangle> on_device(triangles);
    return to_host(build_lbvh({on_device.data(), int(triangles.size())}));
}

} // namespace raylab::lab04
