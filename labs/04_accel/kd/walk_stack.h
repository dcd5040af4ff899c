// The walk with a stack: it goes to the nearer child, and puts the farther one on the stack.
#pragma once

#include "labs/04_accel/kd/ray.h"
#include "labs/04_accel/structure.h"

namespace raylab::lab04 {

template <class Query> HD_HOT void walk_kd_stack(const KdView& tree, Query& query) {
    const KdRay ray(query.ray());
    KdInterval part = inside(tree.bounds, ray);
    if (!(part.begin <= part.end) || is_beyond(part.begin, query.reach())) return;

    struct Later {
        int node;
        double end; // t at which the ray leaves it; it enters where it leaves what comes before
    } later[kd_max_depth];
    int waiting = 0, at = 0;
    for (;;) {
        const KdNode node = tree.nodes[at];
        if (!query.step()) return;
        if (!node.is_leaf()) {
            const double t = ray.t_at(node);
            if (t <= part.begin) {
                at = ray.second(node);
                continue;
            }
            at = ray.first(node);
            if (t < part.end) {
                later[waiting++] = {ray.second(node), part.end};
                part.end = t;
            }
            continue;
        }
        if (visit_leaf(node, query) || waiting == 0 || is_beyond(part.end, query.reach())) return;
        --waiting;
        at = later[waiting].node;
        part = {part.end, later[waiting].end};
    }
}

// For the table of walks (walk_table.h).
struct KdStack {
    static constexpr const char* name = "stack";
    static constexpr const char* title = "a stack";
    static constexpr const char* when_endless =
        "a node that is its own descendant, or that is pushed twice";

    template <class Query> HD static void walk(const StructureView& structure, Query& query) {
        walk_kd_stack(structure.kd, query);
    }
};

} // namespace raylab::lab04
