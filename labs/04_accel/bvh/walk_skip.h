// The shortest of all walks: forward, one node after the other.
#pragma once

#include "common/task/not_implemented.h"
#include "labs/04_accel/bvh/skip_tree.h"
#include "labs/04_accel/leaf/visit_all.h"

namespace raylab::lab04 {

template <class Query> HD void walk_bvh_skip(const SkipView& line, Query& query) {
    //[ task 4.7
    int at = 0;
    while (at < line.nodes.size) {
        if (!query.step()) return;
        const SkipNode& node = line.nodes[at];
        const bool met = crosses(node.box, query.slab, query.reach());
        if (met && node.block >= 0 && query.visit(node.block)) return;
        at = met ? at + 1 : node.skip;
    }
    //| not_implemented("4.7", "walk_bvh_skip()");
    //| visit_all_blocks(query);
    //]
}

} // namespace raylab::lab04
