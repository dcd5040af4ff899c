// Without a stack: a trail of eight bits a level, and parent pointers.
//
// A bit says that a child was crossed and is still to be visited. Sixteen levels are two machine
// words, shifted down a level's bits when the walk descends and back when it climbs: that is all
// the walk remembers, in registers.
#pragma once

#include "labs/04_accel/wide_bvh.h"

namespace raylab::lab04 {

// Eight bits for each level above the current one.
struct Trail {
    std::uint64_t low = 0, high = 0;

    HD void push(std::uint32_t bits) {
        high = high << 8 | low >> 56;
        low = low << 8 | bits;
    }
    HD std::uint32_t pop() {
        const std::uint32_t bits = low & 0xff;
        low = low >> 8 | high << 56;
        high >>= 8;
        return bits;
    }
};

template <class Query> HD void walk_wide_trail(const WideView& bvh, Query& query) {
    if (bvh.nodes.size == 0) return;
    const WideRay ray(query.ray(), bvh.extent);
    Trail trail;
    const WideNode* node = &bvh.nodes[0];
    std::uint32_t left = node->inner | node->leaf; // of this node, to be visited
    while (true) {
        while (left == 0) {
            if (node->parent < 0) return;
            node = &bvh.nodes[node->parent];
            left = trail.pop();
        }
        if (!query.step()) return;
        const WideCrossing crossing = crossed(*node, ray, query.reach(), left);
        left = crossing.slots & ~(1u << crossing.first);
        if (crossing.slots == 0) continue;
        if (node->leaf >> crossing.first & 1) {
            if (query.visit(block_in(*node, crossing.first))) return;
        } else {
            trail.push(left);
            node = &bvh.nodes[child_in(*node, crossing.first)];
            left = node->inner | node->leaf;
        }
    }
}

} // namespace raylab::lab04
