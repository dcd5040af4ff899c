// Top down: a node is cut in two where the surface area heuristic says, until its triangles fit
// into one block, which is a leaf.
#include "labs/04_accel/bvh_sah.h"

#include "labs/04_accel/bvh_split.h"
#include "labs/04_accel/leaf_blocks.h"

#include <algorithm>
#include <array>
#include <bit>

namespace raylab::lab04 {
namespace {

// Cuts through triangles are tried where the children's boxes would overlap by more than this share
// of the scene's, and as long as there are no more references than this for each triangle.
constexpr double least_overlap = 1e-3, most_references = 1.4;

struct Child {
    int child; // as in BvhNode
    Bounds box;
};

struct Builder {
    const std::vector<Triangle>& triangles;
    KdClip clip;
    double root_area;
    std::size_t references; // so far
    BvhTree tree;

    Child leaf(Items items) {
        std::array<int, triangles_per_block> indices;
        Bounds box;
        for (std::size_t i = 0; i < items.size(); ++i) {
            indices[i] = items[i].index;
            box.include(items[i].box);
        }
        append_blocks(triangles, {indices.data(), items.size()}, tree.blocks);
        return {~static_cast<int>(tree.blocks.size() - 1), box};
    }

    // The half with fewer triangles at the front, wherever they lie.
    std::size_t cut_at_median(Items items, const Bounds& centres, int& axis) {
        const Vec3 extent = centres.high - centres.low;
        axis =
            extent.x >= extent.y ? (extent.x >= extent.z ? 0 : 2) : (extent.y >= extent.z ? 1 : 2);
        const std::size_t half = items.size() / 2;
        std::nth_element(items.begin(), items.begin() + half, items.end(),
                         [&](const BuildItem& a, const BuildItem& b) {
                             return a.centre(axis) < b.centre(axis) ||
                                    (a.centre(axis) == b.centre(axis) && a.index < b.index);
                         });
        return half;
    }

    Child build(Items items, int parent, int depth) {
        tree.depth = std::max(tree.depth, depth);
        if (items.size() <= triangles_per_block) return leaf(items);
        const int self = static_cast<int>(tree.nodes.size());
        tree.nodes.push_back({{}, {no_child, no_child}, parent, 0});

        const Bounds centres = centres_of(items);
        // A tree of medians below may still need this many levels.
        const int halvings = std::bit_width(items.size());
        const bool deep = depth + halvings >= max_sah_depth;
        Split split = deep ? Split{} : best_cut_between(items, centres);
        if (!deep && split.overlap > least_overlap * root_area &&
            references < most_references * triangles.size()) {
            Bounds box;
            for (const BuildItem& item : items) box.include(item.box);
            const Split through = best_cut_through(items, box, triangles, clip);
            if (through.cost < split.cost) {
                std::vector<BuildItem> left, right;
                cut_through(items, triangles, clip, through, left, right);
                if (!left.empty() && !right.empty() && left.size() < items.size() &&
                    right.size() < items.size()) {
                    references += left.size() + right.size() - items.size();
                    return finish(self, through.axis, build(left, self, depth + 1),
                                  build(right, self, depth + 1));
                }
            }
        }
        int axis = split.axis;
        std::size_t middle = axis >= 0 ? cut_between(items, centres, split) : 0;
        // No cut, or one that parts nothing and would be made again and again.
        if (middle == 0 || middle == items.size()) middle = cut_at_median(items, centres, axis);
        const Child left = build(items.subspan(0, middle), self, depth + 1);
        return finish(self, axis, left, build(items.subspan(middle), self, depth + 1));
    }

    // A tree of one leaf: a root with nothing on its other side.
    void hang(const Child& leaf) {
        tree.nodes.push_back({{}, {no_child, no_child}, -1, 0});
        finish(0, 0, leaf, {no_child, {}});
    }

    Child finish(int self, int axis, const Child& left, const Child& right) {
        BvhNode& node = tree.nodes[self];
        node.axis = axis;
        const Child* half[2] = {&left, &right};
        for (int k = 0; k < 2; ++k) {
            for (int a = 0; a < 3; ++a) {
                node.box[a][0][k] = half[k]->box.low[a];
                node.box[a][1][k] = half[k]->box.high[a];
            }
            node.child[k] = half[k]->child;
        }
        Bounds box = left.box;
        box.include(right.box);
        return {self, box};
    }
};

} // namespace

BvhTree build_bvh_sah(const std::vector<Triangle>& triangles) {
    std::vector<BuildItem> items = build_items(triangles);
    if (items.empty()) return {};
    Bounds box;
    for (const BuildItem& item : items) box.include(item.box);
    const float largest = max_component(glm::max(abs(box.low), abs(box.high)));
    Builder builder{triangles, KdClip(largest), half_area(box), items.size(), {}};
    const Child root = builder.build(items, -1, 0);
    if (is_leaf(root.child)) builder.hang(root);
    return std::move(builder.tree);
}

} // namespace raylab::lab04
