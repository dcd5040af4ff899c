// Without a stack and without a trail: where to go next follows from where the walk comes from.
//
// The sign of the ray's direction, along the axis on which the children lie apart, tells which
// child is the near one. (Shadow rays visit the other one first, see leaf/query.h.) So the answer
// is the same whenever the walk comes to the node. From above it goes to the near child, back from
// the near child to the far one, back from the far child up. The price: on the way back it tests
// boxes again. Hapala, Davidovic, Wald, Havran and Slusallek, Efficient Stack-less BVH Traversal
// for Ray Tracing, SCCG 2011.
#pragma once

#include "common/task/not_implemented.h"
#include "labs/04_accel/bvh/bvh.h"
#include "labs/04_accel/leaf/visit_all.h"
#include "labs/04_accel/structure.h"

namespace raylab::lab04 {

template <class Query> HD void walk_bvh_parent(const BvhView& bvh, Query& query) {
    if (bvh.nodes.size == 0) return;
    // Steps:
    // 1. Begin at the root, coming from above. At each node a step().
    // 2. Which child is the near one follows from the query and the node's axis, always the same.
    // 3. Which child to look at: from above the near one, back from it the far one, else none.
    // 4. Cross both boxes within reach: a near child that is missed gives its turn to the far one,
    //    a far one that is missed to none.
    // 5. None: up, coming back from this node; at the root return.
    // 6. A leaf: visit it, return if it says so, and come back from it. A node: down, from above.
    //[ task 4.8
    int node = 0, from = -1; // -1: from above
    while (true) {
        if (!query.step()) return;
        const BvhNode& here = bvh.nodes[node];
        const int near = query.first(here.axis);
        int next = from < 0 ? near : from == near ? 1 - near : -1; // the child to look at; -1: up
        from = -1;
        if (next >= 0) {
            const PairCrossing pair = cross(here, query.slab, query.reach());
            if (next == near && !(near ? pair.met1 : pair.met0)) next = 1 - near;
            if (!(next ? pair.met1 : pair.met0)) next = -1;
        }
        if (next < 0) { // up
            if (here.parent < 0) return;
            from = bvh.nodes[here.parent].child[1] == node;
            node = here.parent;
        } else if (is_leaf(here.child[next])) {
            if (query.visit(~here.child[next])) return;
            from = next; // and back at once
        } else {
            node = here.child[next];
        }
    }
    //| not_implemented("4.8", "walk_bvh_parent()");
    //| visit_all_packs(query);
    //]
}

// For the table of walks (walk_table.h).
struct BvhParent {
    static constexpr const char* name = "parent";
    static constexpr const char* title = "parent pointers";
    static constexpr const char* when_endless =
        "a way up that turns down again: coming from the second child, go on up";

    template <class Query> HD static void walk(const StructureView& structure, Query& query) {
        walk_bvh_parent(structure.bvh, query);
    }
};

} // namespace raylab::lab04
