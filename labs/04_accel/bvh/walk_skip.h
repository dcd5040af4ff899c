// The shortest of all walks: forward, one node after the other.
#pragma once

#include "common/task/not_implemented.h"
#include "labs/04_accel/bvh/skip_tree.h"
#include "labs/04_accel/leaf/visit_all.h"
#include "labs/04_accel/trees.h"

namespace raylab::lab04 {

template <class Query> HD void walk_bvh_skip(const SkipView& line, Query& query) {
    // Steps:
    // 1. Begin at the line's first node, and go on to the line's end, with a step() at each node.
    // 2. Does the ray cross the node's box within reach?
    // 3. If so and if it is a leaf, visit its pack; return if the visit says so.
    // 4. On to the next node if the box was met, else to where the skip link leads.
    //[ task 4.7
    int at = 0;
    while (at < line.nodes.size) {
        if (!query.step()) return;
        const SkipNode& node = line.nodes[at];
        const bool met = crosses(node.box, query.slab, query.reach());
        if (met && node.pack >= 0 && query.visit(node.pack)) return;
        at = met ? at + 1 : node.skip;
    }
    //| not_implemented("4.7", "walk_bvh_skip()");
    //| visit_all_packs(query);
    //]
}

// For the table of walks (walk_table.h).
struct BvhSkip {
    static constexpr const char* name = "skip";
    static constexpr const char* title = "skip links";
    static constexpr const char* when_endless =
        "a skip link that leads to its own node or back to one before it";

    // The line is all that this walk reads.
    static void prepare(Trees& trees) {
        trees.skip = lay_skip_links(trees.bvh);
        trees.bvh.nodes = {};
    }

    template <class Query> HD static void walk(const StructureView& structure, Query& query) {
        walk_bvh_skip(structure.skip, query);
    }
};

} // namespace raylab::lab04
