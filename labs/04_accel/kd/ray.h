// What the walks of a KD-tree share: where a ray meets a plane, and why no hit is lost to rounding.
//
// All walks compute the t of a plane by the same three operations in double, and they compare only
// such t. So all walks see the planes that a ray meets in one order, and visit the same leaves.
//
// Rounding may put the place of a hit outside the cell in which a walk looks for it:
// - t has three roundings, so the place on the ray is off by up to 3 * 2^-53 of its distance;
// - the triangle test counts a ray as inside if it passes an edge outside by up to 2^-49 of the
//   corners' distance (edge_error() in sheared_ray.h), and by more if the edge lies almost along
//   the ray: then by up to the ratio of the edge's length to the length that the ray sees of it.
// Therefore a leaf holds every triangle that comes within a margin of its cell (builder/clip.h).
// The margin is at least 2^-40 of the scene's largest coordinate. No hit is lost as long as the
// origin is only some times the scene's size away, and the triangle is not seen edge-on to the last
// digits of a float.
//
// For a ray in a split plane t is 0 * infinity, a NaN. Every comparison with a NaN is false, so the
// ray goes to the first child; the second child would be right too.
#pragma once

#include "common/geometry/ray.h"
#include "labs/04_accel/kd/tree.h"

namespace raylab::lab04 {

struct KdRay {
    DVec3 o, inv_d;
    int down = 0; // bit k: the ray goes down axis k

    HD_HOT explicit KdRay(const Ray& ray) : o(ray.o), inv_d(1.0 / DVec3(ray.d)) {
        down = (inv_d.x < 0) | (inv_d.y < 0) << 1 | (inv_d.z < 0) << 2;
    }

    // 1: the ray goes down this axis; 0: up.
    HD_HOT int is_down(int axis) const { return down >> axis & 1; }

    HD_HOT double t_at(int axis, float plane) const {
        return (plane - along(o, axis)) * along(inv_d, axis);
    }
    HD_HOT double t_at(const KdNode& node) const { return t_at(node.axis(), node.split); }

    // Of the two children, the one that the ray comes to first.
    HD_HOT int first(const KdNode& node) const { return node.below() + is_down(node.axis()); }
    HD_HOT int second(const KdNode& node) const { return node.above() - is_down(node.axis()); }
};

// The part of a ray inside a cell.
struct KdInterval {
    double begin, end;
};

// The part of the ray inside the box, from the ray's origin on. end < begin: there is none.
HD_HOT KdInterval inside(const Bounds& box, const KdRay& ray) {
    KdInterval part{0, infinity};
    for (int axis = 0; axis < 3; ++axis) {
        const float low = along(box.low, axis), high = along(box.high, axis);
        const double enter = ray.t_at(axis, ray.is_down(axis) ? high : low);
        const double leave = ray.t_at(axis, ray.is_down(axis) ? low : high);
        if (enter > part.begin) part.begin = enter;
        if (leave < part.end) part.end = leave;
    }
    return part;
}

// Can nothing that begins at t matter any more? reach is the t of a hit, which was rounded to float
// and is off by up to 2^-24 of itself. The margin is eight times that, 2^-21, so that a hit with
// the same rounded t and a lower id is still found.
HD_HOT bool is_beyond(double t, float reach) { return reach < t * (1 - 0x1p-21); }

// Calls query.visit() for the packs of a leaf. True: the walk may end.
template <class Query> HD_HOT bool visit_leaf(const KdNode& leaf, Query& query) {
    for (int i = 0; i < leaf.packs(); ++i)
        if (query.visit(leaf.first_pack + i)) return true;
    return false;
}

// Brute force: every pack of the tree.
template <class Query> HD void visit_all(const KdView& tree, Query& query) {
    for (int pack = 0; pack < tree.packs; ++pack)
        if (query.visit(pack)) return;
}

} // namespace raylab::lab04
