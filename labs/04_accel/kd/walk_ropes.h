// The walk along ropes: out of a leaf through one of its faces, and on with what lies behind it.
// Popov et al., Stackless KD-Tree Traversal for High Performance GPU Ray Tracing, 2007, section 4.
#pragma once

#include "common/task/not_implemented.h"
#include "labs/04_accel/kd/ray.h"
#include "labs/04_accel/kd/ropes.h"
#include "labs/04_accel/trees.h"

namespace raylab::lab04 {

template <class Query> HD_HOT void walk_kd_ropes(const KdView& tree, Query& query) {
    // Steps:
    // 1. Find the part of the ray inside the root's cell; without one there is nothing to do.
    // 2. Until there is no node, or t is beyond reach:
    // 3. Go down to the leaf, with a step() at each node: past a plane that the ray has met by t to
    //    the second child, else to the first.
    // 4. Of the three faces that the ray moves towards, take the one of least t: that t, its rope.
    // 5. Visit the leaf; return if it says so.
    //[ task 4.3
    const KdRay ray(query.ray());
    const KdInterval part = inside(tree.bounds, ray);
    if (!(part.begin <= part.end)) return;

    double t = part.begin;
    int at = 0;
    while (at != no_rope && !is_beyond(t, query.reach())) {
        // Down to the leaf that the ray is in from t on: past the planes that it has met by then.
        KdNode node;
        for (;;) {
            node = tree.nodes[at];
            if (!query.step()) return;
            if (node.is_leaf()) break;
            at = ray.t_at(node) <= t ? ray.second(node) : ray.first(node);
        }
        // Out through the first of the three faces that the ray moves towards. The next node is
        // found before the packs are tested, so that the loads from memory overlap.
        const KdLeaf& leaf = tree.leaves[tree.leaf_of[at]];
        t = infinity;
        at = no_rope;
        for (int k = 0; k < 3; ++k) {
            const bool down = ray.is_down(k);
            const double leave = ray.t_at(k, (down ? leaf.cell.low : leaf.cell.high)[k]);
            if (leave < t) {
                t = leave;
                at = leaf.rope[2 * k + !down];
            }
        }
        if (visit_leaf(node, query)) return;
    }
    //| not_implemented("4.3", "walk_kd_ropes()");
    //| visit_all(tree, query);
    //]
}

// For the table of walks (walk_table.h).
struct KdRopes {
    static constexpr const char* name = "ropes";
    static constexpr const char* title = "ropes";
    static constexpr const char* when_endless =
        "a rope that leads back into the leaf it left, or a t that shrinks";

    static void prepare(Trees& trees) { lay_ropes(trees.kd); }

    template <class Query> HD static void walk(const StructureView& structure, Query& query) {
        walk_kd_ropes(structure.kd, query);
    }
};

} // namespace raylab::lab04
