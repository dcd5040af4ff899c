// A tree over sorted codes, every node found by a thread of its own.
//
// n sorted leaves have n - 1 inner nodes. Number these so that node i covers a range of leaves that
// begins or ends at leaf i. Whether it begins or ends there, and how far it goes, follows from the
// codes around leaf i alone. So all levels are built at once, while a recursion would have to wait
// for the level above. Karras, Maximizing Parallelism in the Construction of
// BVHs, Octrees, and k-d Trees, HPG 2012, section 4.
#pragma once

#include "common/scene/view.h"
#include "common/task/not_implemented.h"

#include <cstdint>

namespace raylab::lab04 {

HD int leading_zeros(std::uint32_t x) {
#if defined(__CUDA_ARCH__)
    return __clz(static_cast<int>(x));
#else
    return x == 0 ? 32 : __builtin_clz(x);
#endif
}

// The first bits that the codes of leaves i and j share; more for closer neighbours. Leaves with
// the same code are told apart by their numbers, as if those were written behind the code. -1 where
// there is no leaf j.
HD int shared_bits(Array<std::uint32_t> codes, int i, int j) {
    if (j < 0 || j >= codes.size) return -1;
    if (codes[i] != codes[j]) return leading_zeros(codes[i] ^ codes[j]);
    return 32 + leading_zeros(static_cast<std::uint32_t>(i ^ j));
}

// An inner node: it covers leaves first ... last, its children first ... split and split + 1 ...
// last. A child that covers one leaf is that leaf; else it is the inner node of that number.
struct KarrasNode {
    int first, last, split;

    HD bool left_is_leaf() const { return split == first; }
    HD bool right_is_leaf() const { return split + 1 == last; }
};

// Node i of n - 1, n > 1. Node 0 is the root.
HD KarrasNode karras_node(Array<std::uint32_t> codes, int i) {
    // Steps:
    // 1. Which neighbour of i is closer? The range goes to its side.
    // 2. Double the reach until a leaf shares no more bits with i than the other neighbour does.
    // 3. Halve the step to find the last leaf that shares more: the range's other end.
    // 4. How many bits does all of the range share? Halve again to find the last leaf, from i on,
    //    that shares more: there the range is split.
    // 5. Return first, last and split for either direction; split is where the left half ends.
    //[ task 4.5
    // The range goes to the side on which the neighbour is closer,
    const int step = shared_bits(codes, i, i + 1) > shared_bits(codes, i, i - 1) ? 1 : -1;
    // and as far as leaves share more bits with i than the neighbour on the other side does.
    const int outside = shared_bits(codes, i, i - step);
    std::int64_t reach = 2;
    while (shared_bits(codes, i, static_cast<int>(i + reach * step)) > outside) reach *= 2;
    int length = 0;
    for (int part = static_cast<int>(reach / 2); part >= 1; part /= 2)
        if (shared_bits(codes, i, i + (length + part) * step) > outside) length += part;
    const int other_end = i + length * step;

    // It is split where the first bit changes that not all of the range share.
    const int common = shared_bits(codes, i, other_end);
    int split = 0;
    for (int part = length; part > 1;) {
        part = (part + 1) / 2;
        if (split + part < length && shared_bits(codes, i, i + (split + part) * step) > common)
            split += part;
    }
    const int first = step > 0 ? i : other_end, last = step > 0 ? other_end : i;
    return {first, last, step > 0 ? i + split : i - split - 1};
    //| not_implemented("4.5", "karras_node()");
    //| return {};
    //]
}

} // namespace raylab::lab04
