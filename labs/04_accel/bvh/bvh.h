// The binary tree of boxes, as a walk reads it.
//
// A node holds the boxes of both its children, side by side. A walk asks at each node: which of the
// two does the ray cross, and which one first? So one cache line holds all that it needs. The box
// of the node itself is in its parent. Aila and Laine, Understanding the Efficiency of Ray
// Traversal on GPUs, HPG 2009, section 3.
#pragma once

#include "common/geometry/bounds.h"
#include "common/scene/view.h"

#include <cstddef>
#include <vector>

namespace raylab::lab04 {

// A child is a node (>= 0), a leaf of one pack (~pack < 0), or nothing, with a box that no ray
// crosses.
struct BvhNode {
    float box[3][2][2]; // axis, side (0 low, 1 high), child
    int child[2];
    int parent; // -1: the root
    int axis;   // along which the children lie apart; child 0 is the lower one
};
static_assert(sizeof(BvhNode) == 64, "a cache line");

constexpr int no_child = -1 - 0x7fffffff; // the lowest int: no pack has this number
constexpr bool is_leaf(int child) { return child < 0; }

// No deeper than this: a stack of so many nodes, or bits, is enough for every walk. Codes of 30
// bits and numbers of up to 2^31 leaves behind them (lbvh/karras.h) cannot make a longer path.
constexpr int max_bvh_depth = 62;

struct BvhView {
    Array<BvhNode> nodes; // the root first; none: no triangle
};

// Where a ray is within the boxes of a node's children.
struct PairCrossing {
    float near0, near1; // t at which it enters
    bool met0, met1;
};

// If either is a NaN the comparison is false, and the result is b. One instruction on either
// machine.
HD_HOT float larger(float a, float b) { return a > b ? a : b; }
HD_HOT float smaller(float a, float b) { return a < b ? a : b; }

// The parts of the ray inside two boxes, as far as the axes tell that have been looked at.
struct PairInterval {
    float near0, near1, far0, far1;

    // sides: the faces of the boxes across one axis. negative: the ray goes down that axis.
    HD_HOT void narrow(const float (&sides)[2][2], bool negative, float o, float inv_d) {
        const float* enter = sides[negative];
        const float* leave = sides[1 - negative];
        near0 = larger((enter[0] - o) * inv_d, near0);
        near1 = larger((enter[1] - o) * inv_d, near1);
        far0 = smaller((leave[0] - o) * inv_d, far0);
        far1 = smaller((leave[1] - o) * inv_d, far1);
    }
};

// Which of the two boxes does the ray cross within [0, t_max]? As crosses() in bounds.h, for both
// at once: the sign of d tells which face is the near one, and a t that is a NaN leaves the
// interval as it was.
HD_HOT PairCrossing cross(const BvhNode& node, const SlabRay& ray, float t_max) {
    PairInterval t{0, 0, t_max, t_max};
    t.narrow(node.box[0], ray.negative[0], ray.o.x, ray.inv_d.x);
    t.narrow(node.box[1], ray.negative[1], ray.o.y, ray.inv_d.y);
    t.narrow(node.box[2], ray.negative[2], ray.o.z, ray.inv_d.z);
    constexpr float room = 1 + 2 * gamma_bound(3); // each t, near and far, has three roundings
    return {t.near0, t.near1, t.near0 <= t.far0 * room, t.near1 <= t.far1 * room};
}

} // namespace raylab::lab04
