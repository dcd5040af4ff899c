// Top down, with bins. Wald, On Fast Construction of SAH-based Bounding Volume Hierarchies, 2007.
//
// A node with n triangles is cut where the expected cost of a ray is least,
//     cost = A_left / A * blocks(n_left) + A_right / A * blocks(n_right),
// over planes between `bins` slices of the box of the centres. A leaf is one block, so a node is
// cut until its triangles fit into one, and counts of blocks, not of triangles, are what a ray pays
// for.
#include "labs/04_accel/bvh_sah.h"

#include "labs/04_accel/build_items.h"
#include "labs/04_accel/leaf_blocks.h"

#include <algorithm>
#include <array>
#include <bit>
#include <span>

namespace raylab::lab04 {
namespace {

constexpr int bins = 32;

using Items = std::span<BuildItem>;

struct Split {
    double cost = infinity;
    int axis = -1, plane = 0; // bins 0 .. plane - 1 go to the left
};

struct Bin {
    Bounds box;
    int count = 0;
};

// The slices of the box of centres along an axis.
struct Slices {
    float low, scale;
    int operator()(float centre) const {
        return std::clamp(static_cast<int>((centre - low) * scale), 0, bins - 1);
    }
};

Slices slices(const Bounds& centres, int axis) {
    const float low = (&centres.low.x)[axis], high = (&centres.high.x)[axis];
    return {low, static_cast<float>(bins * (1 - 1e-6) / (double(high) - low))};
}

double paid(int count) { return (count + 3) / 4; }

Split best_split(Items items, const Bounds& centres) {
    Split best;
    for (int axis = 0; axis < 3; ++axis) {
        if (!((&centres.high.x)[axis] > (&centres.low.x)[axis])) continue;
        const Slices slice = slices(centres, axis);
        std::array<Bin, bins> bin;
        for (const BuildItem& item : items) {
            Bin& b = bin[slice(item.centre(axis))];
            b.box.include(item.box);
            ++b.count;
        }
        std::array<double, bins> right_cost;
        Bounds box;
        int count = 0;
        for (int i = bins - 1; i > 0; --i) {
            box.include(bin[i].box);
            count += bin[i].count;
            right_cost[i] = count > 0 ? half_area(box) * paid(count) : 0;
        }
        box = {};
        count = 0;
        for (int plane = 1; plane < bins; ++plane) {
            box.include(bin[plane - 1].box);
            count += bin[plane - 1].count;
            if (count == 0 || count == static_cast<int>(items.size())) continue;
            const double cost = half_area(box) * paid(count) + right_cost[plane];
            if (cost < best.cost) best = {cost, axis, plane};
        }
    }
    return best;
}

struct Builder {
    const std::vector<Triangle>& triangles;
    BvhTree tree;

    struct Child {
        int child;
        Bounds box;
    };

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

    // Cuts in two; returns the first of the second half.
    std::size_t cut(Items items, int depth, int& axis) {
        Bounds centres;
        for (const BuildItem& item : items)
            centres.include({item.centre(0), item.centre(1), item.centre(2)});
        const int halvings = std::bit_width(items.size()); // that a tree of medians may still need
        const bool deep = depth + halvings >= max_bvh_depth;
        const Split split = deep ? Split{} : best_split(items, centres);
        if (split.axis >= 0) {
            axis = split.axis;
            const Slices slice = slices(centres, axis);
            const auto middle =
                std::partition(items.begin(), items.end(), [&](const BuildItem& item) {
                    return slice(item.centre(axis)) < split.plane;
                });
            return middle - items.begin();
        }
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
        tree.nodes.push_back({.parent = parent});
        int axis = 0;
        const std::size_t middle = cut(items, depth, axis);
        const Child half[2] = {build(items.subspan(0, middle), self, depth + 1),
                               build(items.subspan(middle), self, depth + 1)};
        BvhNode& node = tree.nodes[self];
        node.axis = axis;
        Bounds box;
        for (int k = 0; k < 2; ++k) {
            for (int a = 0; a < 3; ++a) {
                node.box[a][0][k] = (&half[k].box.low.x)[a];
                node.box[a][1][k] = (&half[k].box.high.x)[a];
            }
            node.child[k] = half[k].child;
            box.include(half[k].box);
        }
        return {self, box};
    }
};

} // namespace

BvhTree build_bvh_sah(const std::vector<Triangle>& triangles) {
    std::vector<BuildItem> items = build_items(triangles);
    Builder builder{triangles, {}};
    if (items.empty()) return {};
    builder.build(items, -1, 0);
    return std::move(builder.tree);
}

} // namespace raylab::lab04
