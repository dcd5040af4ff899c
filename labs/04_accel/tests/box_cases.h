// What the tests of boxes share: trees over boxes alone, binary ones and wide ones.
#pragma once

#include "labs/04_accel/tests/bvh_cases.h"

namespace raylab::lab04 {

// A tree over boxes alone: leaf i has box i, and a pack with the one index i.
struct BoxTree {
    std::vector<Bounds> boxes;
    BvhTree tree;

    Bounds build(int first, int last, int parent, int side, Dice& dice) {
        if (last - first == 1) {
            hang_leaf(parent, side, boxes[first]);
            return boxes[first];
        }
        const int self = int(tree.nodes.size());
        tree.nodes.push_back({{}, {no_child, no_child}, parent, dice.below(3)});
        const int middle = first + 1 + dice.below(last - first - 1);
        Bounds box = build(first, middle, self, 0, dice);
        box.include(build(middle, last, self, 1, dice));
        if (parent >= 0) hang(parent, side, self, box);
        return box;
    }

    // Leaves come in the order of their boxes.
    void hang_leaf(int node, int side, const Bounds& box) {
        const int leaf = int(tree.packs.size());
        tree.packs.push_back({{}, {leaf, -1, -1, -1}});
        hang(node, side, ~leaf, box);
    }

    void hang(int node, int side, int child, const Bounds& box) {
        tree.nodes[node].child[side] = child;
        for (int axis = 0; axis < 3; ++axis) {
            tree.nodes[node].box[axis][0][side] = box.low[axis];
            tree.nodes[node].box[axis][1][side] = box.high[axis];
        }
    }
};

// Boxes of all sizes, flat ones among them, around a place that may be far away.
inline BoxTree any_boxes(int n, Dice& dice) {
    BoxTree made;
    const float size = power_of_two(dice, -30, 30);
    const Vec3 place =
        dice.below(2) ? dice.point(-size, size) * power_of_two(dice, 0, 20) : Vec3(0);
    for (int i = 0; i < n; ++i) {
        Bounds box;
        const float extent = size * power_of_two(dice, -12, 0);
        const Vec3 p = place + dice.point(-size, size);
        box.include(p);
        box.include(p + dice.point(-extent, extent));
        if (const int flat = dice.below(6); flat < 3) box.high[flat] = box.low[flat];
        made.boxes.push_back(box);
    }
    made.build(0, n, -1, 0, dice);
    return made;
}

// Calls visit(node, slot, leaf) for each slot of the wide tree, with each leaf below it; returns
// the leaves below `at`.
template <class Visit>
std::vector<int> for_each_slot(const WideTree& tree, int at, const Visit& visit) {
    const WideNode& node = tree.nodes[at];
    std::vector<int> all;
    for (int slot = 0; slot < wide_children; ++slot) {
        std::vector<int> below;
        if (node.leaf >> slot & 1)
            below = {tree.packs[pack_in(node, slot)].index[0]};
        else if (node.inner >> slot & 1)
            below = for_each_slot(tree, child_in(node, slot), visit);
        for (const int leaf : below) visit(at, slot, leaf);
        all.insert(all.end(), below.begin(), below.end());
    }
    return all;
}

} // namespace raylab::lab04
