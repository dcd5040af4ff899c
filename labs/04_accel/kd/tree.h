// A KD-tree: space is cut in two by a plane across an axis, and each half again.
// Wald and Havran, On Building Fast kd-Trees for Ray Tracing, and on Doing that in O(N log N),
// 2006; Popov et al., Stackless KD-Tree Traversal for High Performance GPU Ray Tracing, 2007 (the
// ropes).
//
// Its cells do not overlap, so a ray goes through them in order, and what it hits in one lies
// before all that it could hit in the next. The price: a triangle is held by every cell that it
// reaches.
#pragma once

#include "common/geometry/bounds.h"
#include "common/scene/view.h"
#include "labs/04_accel/leaf/triangle_pack.h"

#include <cstdint>
#include <vector>

namespace raylab::lab04 {

// No leaf lies deeper than this, whatever the triangles are. So a walk's stack needs no more
// entries.
constexpr int kd_max_depth = 60;

// Eight bytes. The two children of a node lie side by side: below the plane, then above it.
struct KdNode {
    union {
        float split;             // inner: where on the axis the plane is
        std::int32_t first_pack; // leaf
    };
    std::uint32_t tail; // inner: the axis, 0 to 2, and the lower child; leaf: 3 and how many packs

    static KdNode inner(int axis, float split, int below) {
        KdNode node;
        node.split = split;
        node.tail = std::uint32_t(axis) | std::uint32_t(below) << 2;
        return node;
    }
    static KdNode leaf(int first_pack, int packs) {
        KdNode node;
        node.first_pack = first_pack;
        node.tail = 3 | std::uint32_t(packs) << 2;
        return node;
    }
    HD bool is_leaf() const { return (tail & 3) == 3; }
    HD int axis() const { return int(tail & 3); }
    HD int below() const { return int(tail >> 2); }
    HD int above() const { return below() + 1; }
    HD int packs() const { return int(tail >> 2); }
};

static_assert(sizeof(KdNode) == 8);

constexpr int no_rope = -1; // behind this face the scene ends

// What only the walk along ropes reads. Face 2 * axis is the cell's lower face across that axis,
// face 2 * axis + 1 the upper one. The rope of a face leads to the smallest node whose cell covers
// the whole face from the other side.
struct KdLeaf {
    Bounds cell;
    int rope[6];
};

// The tree as a walk sees it.
struct KdView {
    Bounds bounds; // the root's cell
    Array<KdNode> nodes;
    Array<std::int32_t> leaf_of; // by node: its index in leaves, or -1 if it is an inner node
    Array<KdLeaf> leaves;
    int packs = 0; // of all leaves together
};

// The tree as it is built. Nodes: the root first; none if there is no triangle.
struct KdTree {
    Bounds bounds;
    std::vector<KdNode> nodes;
    std::vector<std::int32_t> leaf_of;
    std::vector<KdLeaf> leaves;
    std::vector<TrianglePack> packs;

    std::size_t bytes() const {
        return nodes.size() * sizeof nodes[0] + leaf_of.size() * sizeof leaf_of[0] +
               leaves.size() * sizeof leaves[0] + packs.size() * sizeof packs[0];
    }
    // For walks on the host.
    KdView view() const {
        return {bounds,
                {nodes.data(), int(nodes.size())},
                {leaf_of.data(), int(leaf_of.size())},
                {leaves.data(), int(leaves.size())},
                int(packs.size())};
    }
};

} // namespace raylab::lab04
