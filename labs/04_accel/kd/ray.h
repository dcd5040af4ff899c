// What the walks of a KD-tree share: where a ray meets a plane, and why no hit is lost to rounding.
//
// All walks compute a plane's t by the same three operations, in double, and compare those t alone.
// So for them the planes that a ray meets have one order, and each walk comes to the same leaves.
//
// A leaf holds every triangle that comes within a margin of its cell (builder/clip.h), at least 2^-40
// of the scene's largest coordinate. Two things may put the place of a hit outside the cell that a
// walk looks for it in. t has three roundings: 3 * 2^-53 |plane - o|, sideways. And the triangle
// test takes a ray to pass an edge that it misses by 2^-49 of the corners' distance (edge_error()
// in sheared_ray.h); by more, up to the ratio of its length to what the ray sees of it, if it lies
// along the ray. So for origins within some scenes around, and triangles that are not seen edge-on
// to the last digits of a float, no hit is lost.
//
// A ray in a split plane may go either way: its t is 0 / 0, every comparison with it is false, and
// the ray stays on the first side.
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

  private:
    // Selected, not indexed: an index would put the ray into a GPU's slow local memory, and makes a
    // CPU wait for it where it could have guessed the axis.
    HD_HOT static double along(const DVec3& v, int axis) {
        return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
    }
};

// The part of a ray inside a cell.
struct KdInterval {
    double begin, end;
};

// Where the ray is inside the box, from its origin on; end < begin: nowhere.
HD_HOT KdInterval inside(const Bounds& box, const KdRay& ray) {
    KdInterval part{0, infinity};
    for (int axis = 0; axis < 3; ++axis) {
        const float low = box.low[axis], high = box.high[axis];
        const double enter = ray.t_at(axis, ray.is_down(axis) ? high : low);
        const double leave = ray.t_at(axis, ray.is_down(axis) ? low : high);
        if (enter > part.begin) part.begin = enter;
        if (leave < part.end) part.end = leave;
    }
    return part;
}

// Is all that begins at t too far away to matter? A hit's t is a float, rounded from its real place
// by 2^-24 of it: a margin of eight times that leaves no hit that could still tie.
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
