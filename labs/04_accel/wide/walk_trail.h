// Without a stack: a trail of eight bits a level, and parent pointers.
//
// A bit says that the box of a child is crossed and that the child is still to be visited. The bits
// of sixteen levels are two machine words, which are shifted by eight bits when the walk goes down
// a level, and back when it climbs. The walk remembers no more than these, and keeps them in
// registers.
#pragma once

#include "labs/04_accel/leaf/fetch_ahead.h"
#include "labs/04_accel/structure.h"
#include "labs/04_accel/wide/wide_bvh.h"

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
    const WideRay ray(query.ray(), query.slab.inv_d, bvh.extent);
    const int octant = octant_of(query);
    const float whole = query.reach();
    Trail trail;
    const WideNode* node = &bvh.nodes[0];
    std::uint32_t left = wide_slots(*node); // slots of this node, still to be visited
    bool fresh = true;                      // the walk comes from above: boxes are not tested yet
    while (true) {
        if (fresh || (Query::reach_shrinks && query.reach() < whole)) {
            if (!query.step()) return;
            left &= crossed(*node, ray, query.reach());
        }
        fresh = false;
        if (left != 0) {
            const int slot = first_in_order(left, node->order[octant]);
            left &= ~(1u << slot);
            if (node->leaf >> slot & 1) {
                if (query.visit(pack_in(*node, slot))) return;
            } else {
                trail.push(left);
                node = &bvh.nodes[child_in(*node, slot)];
                // Before it is known which child comes next.
                fetch_ahead(bvh.nodes.data + node->first_child);
                query.ask_for(node->first_pack);
                left = wide_slots(*node);
                fresh = true;
            }
        }
        while (left == 0) {
            if (node->parent < 0) return;
            node = &bvh.nodes[node->parent];
            left = trail.pop();
        }
    }
}

// For the table of walks (walk_table.h).
struct WideTrail {
    static constexpr const char* name = "trail";
    static constexpr const char* title = "a trail of bits";
    static constexpr const char* when_endless =
        "a bit of the trail that is not cleared when its child was visited";

    template <class Query> HD static void walk(const StructureView& structure, Query& query) {
        walk_wide_trail(structure.wide, query);
    }
};

} // namespace raylab::lab04
