// The tree on the host, as builders make it.
#pragma once

#include "labs/04_accel/bvh/bvh.h"
#include "labs/04_accel/leaf/triangle_pack.h"

#include <vector>

namespace raylab::lab04 {

struct BvhTree {
    std::vector<BvhNode> nodes;      // the root first
    std::vector<TrianglePack> packs; // a leaf each
    int depth = 0;                   // nodes from the root to the deepest leaf

    std::size_t node_bytes() const { return nodes.size() * sizeof(BvhNode); }
    std::size_t pack_bytes() const { return packs.size() * sizeof(TrianglePack); }
};

inline void set_child(BvhNode& node, int k, int child, const Bounds& box) {
    node.child[k] = child;
    for (int axis = 0; axis < 3; ++axis) {
        node.box[axis][0][k] = box.low[axis];
        node.box[axis][1][k] = box.high[axis];
    }
}

inline Bounds child_box(const BvhNode& node, int child) {
    Bounds box;
    for (int axis = 0; axis < 3; ++axis) {
        box.low[axis] = node.box[axis][0][child];
        box.high[axis] = node.box[axis][1][child];
    }
    return box;
}

} // namespace raylab::lab04
