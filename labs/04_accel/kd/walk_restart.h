// The walk that starts over: after each leaf down from the root again, to the leaf behind it.
// Foley and Sugerman, KD-Tree Acceleration Structures for a GPU Raytracer, 2005; the root moves
// down as in Horn et al., Interactive k-D Tree GPU Raytracing, 2007 ("push-down").
//
// Why it ends: on the way down a leaf's end becomes the least t of the planes that the ray has not
// met yet. All of these are greater than the t at which the leaf begins. So each leaf makes the
// rest of the ray shorter, and the next way down goes to the other side of that plane.
#pragma once

#include "common/task/not_implemented.h"
#include "labs/04_accel/kd/ray.h"
#include "labs/04_accel/structure.h"

namespace raylab::lab04 {

template <class Query> HD_HOT void walk_kd_restart(const KdView& tree, Query& query) {
    // Steps:
    // 1. Find the part of the ray inside the root's cell: the rest. Without one return.
    // 2. Until the rest begins beyond reach: go down from the root, with a step() at each node.
    // 3. Past a plane that the ray has met by the rest's begin to the second child; else to the
    //    first, and the leaf ends at this plane at the latest.
    // 4. While the rest lies in one child alone, the root moves down along.
    // 5. Visit the leaf; return if it says so or if it ends where the rest does. The rest begins
    //    where the leaf ends.
    //[ task 4.3
    const KdRay ray(query.ray());
    KdInterval rest = inside(tree.bounds, ray);
    if (!(rest.begin <= rest.end)) return;

    int root = 0; // all the rest of the ray lies in the subtree below
    while (!is_beyond(rest.begin, query.reach())) {
        double end = rest.end;
        int at = root;
        bool only = true; // on this way down the rest was always in one child alone
        KdNode node;
        for (;;) {
            node = tree.nodes[at];
            if (!query.step()) return;
            if (node.is_leaf()) break;
            const double t = ray.t_at(node);
            if (t <= rest.begin) {
                at = ray.second(node);
            } else {
                at = ray.first(node);
                only &= t >= rest.end;
                if (t < end) end = t;
            }
            if (only) root = at;
        }
        if (visit_leaf(node, query) || end >= rest.end) return;
        rest.begin = end;
    }
    //| not_implemented("4.3", "walk_kd_restart()");
    //| visit_all(tree, query);
    //]
}

// For the table of walks (walk_table.h).
struct KdRestart {
    static constexpr const char* name = "restart";
    static constexpr const char* title = "from the root again";
    static constexpr const char* when_endless =
        "a ray's part that does not get shorter: a leaf must end behind where it begins";

    template <class Query> HD static void walk(const StructureView& structure, Query& query) {
        walk_kd_restart(structure.kd, query);
    }
};

} // namespace raylab::lab04
