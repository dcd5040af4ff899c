// The boxes of wide nodes: on the grid they contain the boxes that they stand for, and little more;
// a tree has no more levels than promised, and each order has each slot.
#include "common/geometry/tests/support.h"
#include "labs/04_accel/tests/box_cases.h"

#include <algorithm>

namespace raylab::lab04 {

namespace {

Bounds grid_box(const WideNode& node, int slot) {
    Bounds box;
    for (int axis = 0; axis < 3; ++axis) {
        // Of a float and a number of ten bits and a power of two, rounded as between_faces() does.
        box.low[axis] =
            float(node.origin[axis] + double(node.step) * grid_face(node, slot, axis, 0));
        box.high[axis] =
            float(node.origin[axis] + double(node.step) * grid_face(node, slot, axis, 1));
    }
    return box;
}

bool contains(const WideNode& node, int slot, const Bounds& inner) {
    for (int axis = 0; axis < 3; ++axis) {
        const double origin = node.origin[axis], step = node.step;
        if (origin + step * grid_face(node, slot, axis, 0) > inner.low[axis] ||
            origin + step * grid_face(node, slot, axis, 1) < inner.high[axis])
            return false;
    }
    return true;
}

TEST(WideBoxes, ContainTheBoxesTheyStandFor) {
    Dice dice(31);
    for (int i = 0; i < test::rays(2000, 100000); ++i) {
        const int n = 2 + dice.below(60);
        const BoxTree made = any_boxes(n, dice);
        const WideTree wide = build_wide(made.tree);
        int outside = 0;
        std::vector<int> leaves = for_each_slot(wide, 0, [&](int node, int slot, int leaf) {
            outside += !contains(wide.nodes[node], slot, made.boxes[leaf]);
        });
        ASSERT_EQ(outside, 0) << "of " << n << " boxes";
        std::sort(leaves.begin(), leaves.end());
        ASSERT_EQ(int(leaves.size()), n);
        for (int leaf = 0; leaf < n; ++leaf) ASSERT_EQ(leaves[leaf], leaf);
    }
}

// A box is no wider than it is by more than a step on either side.
TEST(WideBoxes, AreTight) {
    Dice dice(32);
    for (int i = 0; i < 500; ++i) {
        const BoxTree made = any_boxes(8, dice);
        const WideTree wide = build_wide(made.tree);
        for_each_slot(wide, 0, [&](int at, int slot, int leaf) {
            const WideNode& node = wide.nodes[at];
            if (!(node.leaf >> slot & 1)) return;
            const Bounds grid = grid_box(node, slot), &box = made.boxes[leaf];
            for (int axis = 0; axis < 3; ++axis) {
                ASSERT_GE(grid.low[axis], box.low[axis] - 1.001f * node.step);
                ASSERT_LE(grid.high[axis], box.high[axis] + 1.001f * node.step);
            }
        });
    }
}

TEST(WideBoxes, EachOrderHasEachSlotOnce) {
    for (const auto& triangles : {hills(24), soup(1000, 0.3f), soup(5, 1)}) {
        for (const WideNode& node : build_wide(build_bvh_sah(triangles)).nodes) {
            const int slots = count_bits(wide_slots(node));
            for (const std::uint32_t order : node.order) {
                std::uint32_t seen = 0;
                for (int place = 0; place < slots; ++place) seen |= 1u << (order >> 3 * place & 7);
                ASSERT_EQ(seen, wide_slots(node));
            }
        }
    }
}

// A tree as deep as there may be: on each level of a chain hangs a bush of seven leaves, so large
// that the plan would make them seven children, and the rest of the chain the eighth.
TEST(WideBoxes, AChainHasNoMoreLevelsThanPromised) {
    BoxTree made;
    const int chain = max_sah_depth - 3;
    int parent = -1;
    for (int level = 0; level < chain; ++level) {
        const int self = int(made.tree.nodes.size());
        made.tree.nodes.push_back({{}, {no_child, no_child}, parent, 0});
        const float tiny = std::ldexp(1.0f, -level);
        if (parent >= 0) made.hang(parent, 1, self, {Vec3(0), Vec3(tiny)});
        // Six nodes as in a heap, and their seven leaves.
        const int first = int(made.tree.nodes.size());
        const Bounds large{Vec3(0), Vec3(2 * tiny)};
        for (int k = 0; k < 13; ++k) {
            const int above = k == 0 ? self : first + (k - 1) / 2, side = k == 0 ? 0 : (k - 1) % 2;
            if (k < 6) {
                made.tree.nodes.push_back({{}, {no_child, no_child}, above, 0});
                made.hang(above, side, first + k, large);
            } else {
                made.hang_leaf(above, side, large);
            }
        }
        parent = self;
    }
    made.hang_leaf(parent, 1, {Vec3(0), Vec3(0)}); // the end of the chain

    const WideTree wide = build_wide(made.tree);
    EXPECT_LE(wide.levels, max_wide_levels);
    std::vector<int> leaves = for_each_slot(wide, 0, [](int, int, int) {});
    std::sort(leaves.begin(), leaves.end());
    ASSERT_EQ(leaves.size(), made.tree.packs.size());
    for (int i = 0; i < int(leaves.size()); ++i) EXPECT_EQ(leaves[i], i);
}

} // namespace

} // namespace raylab::lab04
