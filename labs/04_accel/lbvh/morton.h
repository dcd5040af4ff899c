// The Morton curve: a line through space on which neighbours are mostly neighbours in space.
//
//     code = x9 y9 z9 x8 y8 z8 ... x0 y0 z0        the bits of three coordinates, in turns
// Points whose codes share their first bits lie in the same half, quarter, eighth ... of the scene.
// So to sort triangles by code is to sort them into a tree. Morton, A Computer Oriented Geodetic
// Data Base, 1966; Lauterbach et al., Fast BVH Construction on GPUs, Eurographics 2009.
#pragma once

#include "common/geometry/bounds.h"
#include "common/task/not_implemented.h"

#include <cstdint>

namespace raylab::lab04 {

constexpr int morton_bits = 10; // of each coordinate

// Puts two zeros in front of each of the lowest ten bits.
HD std::uint32_t spread(std::uint32_t x) {
    // Steps:
    // 1. Four times halve the distance: 16, 8, 4, 2. Move the upper half of each group of bits away
    //    by it, and keep by a mask what is in its new place.
    //[ task 4.4
    x = (x | x << 16) & 0x030000ff;
    x = (x | x << 8) & 0x0300f00f;
    x = (x | x << 4) & 0x030c30c3;
    return (x | x << 2) & 0x09249249;
    //| not_implemented("4.4", "spread()");
    //| return 0 * x;
    //]
}

// The code of a point in `box`; what lies outside counts as on the box's face.
HD std::uint32_t morton_code(Vec3 p, const Bounds& box) {
    // Steps:
    // 1. For each axis: how far, from 0 to 1, is p on the way through the box? 0 without extent.
    // 2. Which of the 1024 cells is that? What lies outside is in the first or the last.
    // 3. Spread the cell's bits and put them in their place: x highest, z lowest.
    //[ task 4.4
    constexpr int cells = 1 << morton_bits;
    std::uint32_t code = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const float extent = box.high[axis] - box.low[axis];
        const float share = extent > 0 ? (p[axis] - box.low[axis]) / extent : 0.0f;
        const int cell = static_cast<int>(clamp(share * cells, 0, cells - 1));
        code |= spread(static_cast<std::uint32_t>(cell)) << (2 - axis);
    }
    return code;
    //| not_implemented("4.4", "morton_code()");
    //| return 0; // as if all lay in one point: a tree over the triangles in the order of the file
    //]
}

} // namespace raylab::lab04
