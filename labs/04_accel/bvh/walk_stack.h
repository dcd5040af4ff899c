// The usual walk: the near child first, the far one on a stack. The others are measured against it.
//
// Its stack has 62 pairs of numbers for each thread. On a GPU they lie in local memory, which is as
// slow as global memory.
#pragma once

#include "labs/04_accel/bvh/bvh.h"
#include "labs/04_accel/structure.h"

namespace raylab::lab04 {

template <class Query> HD void walk_bvh_stack(const BvhView& bvh, Query& query) {
    if (bvh.nodes.size == 0) return;
    struct Pending {
        int child;
        float near;
    };
    Pending stack[max_bvh_depth];
    int size = 0, child = 0;
    while (true) {
        if (is_leaf(child)) {
            if (query.visit(~child)) return;
        } else {
            if (!query.step()) return;
            const BvhNode& node = bvh.nodes[child];
            const PairCrossing pair = cross(node, query.slab, query.reach());
            const bool swap = query.first(node.axis);
            const bool near = swap ? pair.met1 : pair.met0, far = swap ? pair.met0 : pair.met1;
            if (near) {
                if (far) stack[size++] = {node.child[1 - swap], swap ? pair.near0 : pair.near1};
                child = node.child[swap];
                continue;
            }
            if (far) {
                child = node.child[1 - swap];
                continue;
            }
        }
        do {
            if (size == 0) return;
            child = stack[--size].child;
        } while (stack[size].near > query.reach() * (1 + 2 * gamma_bound(3)));
    }
}

// For the table of walks (walk_table.h).
struct BvhStack {
    static constexpr const char* name = "stack";
    static constexpr const char* title = "a stack";
    static constexpr const char* when_endless =
        "a node that is its own descendant, or that is pushed twice";

    template <class Query> HD static void walk(const StructureView& structure, Query& query) {
        walk_bvh_stack(structure.bvh, query);
    }
};

} // namespace raylab::lab04
