// The wide walk with a stack. The one with a trail is measured against it.
#pragma once

#include "labs/04_accel/leaf/fetch_ahead.h"
#include "labs/04_accel/structure.h"
#include "labs/04_accel/wide/wide_bvh.h"

namespace raylab::lab04 {

template <class Query> HD void walk_wide_stack(const WideView& bvh, Query& query) {
    if (bvh.nodes.size == 0) return;
    const WideRay ray(query.ray(), query.slab.inv_d, bvh.extent);
    const int octant = octant_of(query);
    const float whole = query.reach();
    struct Pending {
        int node;
        std::uint32_t left;
    };
    Pending stack[max_wide_levels];
    int size = 0, at = 0;
    std::uint32_t left = wide_slots(bvh.nodes[0]); // slots of this node, still to be visited
    bool fresh = true;
    while (true) {
        const WideNode& node = bvh.nodes[at];
        if (fresh || (Query::reach_shrinks && query.reach() < whole)) {
            if (!query.step()) return;
            left &= crossed(node, ray, query.reach());
        }
        fresh = false;
        if (left != 0) {
            const int slot = first_in_order(left, node.order[octant]);
            left &= ~(1u << slot);
            if (node.leaf >> slot & 1) {
                if (query.visit(pack_in(node, slot))) return;
            } else {
                if (left != 0) stack[size++] = {at, left};
                at = child_in(node, slot);
                fetch_ahead(bvh.nodes.data + bvh.nodes[at].first_child);
                query.ask_for(bvh.nodes[at].first_pack);
                left = wide_slots(bvh.nodes[at]);
                fresh = true;
            }
        }
        if (left == 0) {
            if (size == 0) return;
            --size;
            at = stack[size].node;
            left = stack[size].left;
        }
    }
}

// For the table of walks (walk_table.h).
struct WideStack {
    static constexpr const char* name = "stack";
    static constexpr const char* title = "a stack";
    static constexpr const char* when_endless =
        "a node that is its own descendant, or that is pushed twice";

    template <class Query> HD static void walk(const StructureView& structure, Query& query) {
        walk_wide_stack(structure.wide, query);
    }
};

} // namespace raylab::lab04
