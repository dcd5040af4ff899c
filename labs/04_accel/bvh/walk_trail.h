// Without a stack: a bit a level, and parent pointers.
//
// The stack of the usual walk holds the far children that are still to be visited. Each of them is
// a child of a node on the path from the root to the current node. So one bit for each level of
// that path is enough: is the far child of this node still to be visited? Where the usual walk pops
// its stack, this one climbs by parent pointers to the lowest node whose bit is set. Afra and
// Szirmay-Kalos, Stackless Multi-BVH Traversal for CPU, MIC and GPU Ray Tracing, CGF 33(1), 2014;
// Laine, Restart Trail for Stackless BVH Traversal, HPG 2010.
#pragma once

#include "labs/04_accel/bvh/bvh.h"
#include "labs/04_accel/structure.h"

#include <cstdint>

namespace raylab::lab04 {

template <class Query> HD void walk_bvh_trail(const BvhView& bvh, Query& query) {
    if (bvh.nodes.size == 0) return;
    static_assert(max_bvh_depth < 64);
    const float whole = query.reach();
    std::uint64_t trail = 0; // the lowest bit: does the far child of `node` wait?
    int node = 0;
    while (true) {
        // Down, to the child that the query wants first: `near`.
        if (!query.step()) return;
        const BvhNode& here = bvh.nodes[node];
        const PairCrossing pair = cross(here, query.slab, query.reach());
        const bool swap = query.first(here.axis);
        const bool near = swap ? pair.met1 : pair.met0, far = swap ? pair.met0 : pair.met1;
        trail <<= 1;
        int child = no_child;
        if (near) {
            child = here.child[swap];
            if (far) trail |= 1;
        } else if (far) {
            child = here.child[1 - swap];
        }
        if (child >= 0) {
            node = child;
            continue;
        }
        if (child != no_child && query.visit(~child)) return;
        while (true) {
            while ((trail & 1) == 0) { // up
                node = bvh.nodes[node].parent;
                if (node < 0) return;
                trail >>= 1;
            }
            trail ^= 1; // to the far child, if it is still within reach
            const BvhNode& above = bvh.nodes[node];
            const bool other = !query.first(above.axis);
            if (Query::reach_shrinks && query.reach() < whole) {
                if (!query.step()) return;
                const PairCrossing again = cross(above, query.slab, query.reach());
                if (!(other ? again.met1 : again.met0)) continue;
            }
            child = above.child[other];
            if (child >= 0) break;
            if (query.visit(~child)) return;
        }
        node = child;
    }
}

// For the table of walks (walk_table.h).
struct BvhTrail {
    static constexpr const char* name = "trail";
    static constexpr const char* title = "a trail of bits";
    static constexpr const char* when_endless =
        "a bit of the trail that is not cleared when its child was visited";

    template <class Query> HD static void walk(const StructureView& structure, Query& query) {
        walk_bvh_trail(structure.bvh, query);
    }
};

} // namespace raylab::lab04
