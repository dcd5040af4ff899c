// Tasks 4.4 to 4.6: the tree along the Morton curve.
#include "common/sampling/hash.h"
#include "common/task/facts.h"
#include "labs/04_accel/bvh/walk_stack.h"
#include "labs/04_accel/lbvh/build.h"
#include "labs/04_accel/lbvh/karras.h"
#include "labs/04_accel/lbvh/morton.h"
#include "labs/04_accel/lbvh/radix_sort.h"
#include "labs/04_accel/leaf/query.h"
#include "labs/04_accel/tests/cases.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <numeric>
#include <set>

namespace raylab::lab04 {

namespace {

constexpr Bounds unit_cube{Vec3(0), Vec3(1)};

// Bit by bit.
std::uint32_t code_of_cells(int x, int y, int z) {
    std::uint32_t code = 0;
    for (int bit = 0; bit < morton_bits; ++bit)
        code |= (x >> bit & 1) << (3 * bit + 2) | (y >> bit & 1) << (3 * bit + 1) |
                (z >> bit & 1) << 3 * bit;
    return code;
}

Vec3 centre_of_cell(int x, int y, int z) {
    return (Vec3(x, y, z) + 0.5f) / float(1 << morton_bits);
}

TEST(Task4_4, CodesAreTheBitsOfThreeCoordinatesInTurns) {
    Dice dice(1);
    for (int i = 0; i < 10000; ++i) {
        const int x = dice.below(1024), y = dice.below(1024), z = dice.below(1024);
        const std::uint32_t code = morton_code(centre_of_cell(x, y, z), unit_cube);
        ASSERT_EQ(code, code_of_cells(x, y, z)) << fmt::format(
            "the code of cell ({}, {}, {}) is {:030b}, and should be {:030b}: x, y, z in turns, x "
            "first",
            x, y, z, code, code_of_cells(x, y, z));
    }
}

TEST(Task4_4, PointsOnAndOutsideTheBoxAreInItsOuterCells) {
    EXPECT_EQ(morton_code(Vec3(0), unit_cube), 0u);
    EXPECT_EQ(morton_code(Vec3(1), unit_cube), (1u << 30) - 1)
        << "the far corner is in the last cell";
    EXPECT_EQ(morton_code(Vec3(-5), unit_cube), 0u);
    EXPECT_EQ(morton_code(Vec3(7), unit_cube), (1u << 30) - 1);
}

TEST(Task4_4, AFlatBoxHasCodes) {
    const Bounds floor{Vec3(0), Vec3(1, 0, 1)};
    EXPECT_EQ(morton_code(Vec3(0.999f, 0, 0), floor), code_of_cells(1022, 0, 0))
        << "on an axis without extent all are in cell 0";
}

// Sorted codes, some of them equal.
std::vector<std::uint32_t> sorted_codes(int n, std::uint32_t largest) {
    Dice dice(n);
    std::vector<std::uint32_t> codes(n);
    for (std::uint32_t& code : codes) code = dice.below(int(largest));
    std::sort(codes.begin(), codes.end());
    return codes;
}

// Where the leaves first ... last belong to different halves: by definition.
int split_by_definition(const std::vector<std::uint32_t>& codes, int first, int last) {
    const Array<std::uint32_t> array{codes.data(), int(codes.size())};
    const int common = shared_bits(array, first, last);
    int split = first;
    while (split + 1 < last && shared_bits(array, first, split + 1) > common) ++split;
    return split;
}

TEST(Task4_5, NodesAreTheBinaryTreeOfTheCodes) {
    for (const auto& [n, largest] :
         {std::pair{2, 100}, {3, 100}, {33, 1000}, {1000, 1 << 30}, {1000, 50}, {777, 1}}) {
        const std::vector<std::uint32_t> codes = sorted_codes(n, largest);
        const Array<std::uint32_t> array{codes.data(), n};
        std::vector<std::pair<int, int>> open = {{0, n - 1}}; // ranges, from the root down
        std::vector<int> numbers = {0};
        int nodes = 0;
        while (!open.empty()) {
            const auto [first, last] = open.back();
            const int number = numbers.back();
            open.pop_back(), numbers.pop_back();
            ASSERT_LT(nodes++, n) << "the nodes' children go round in circles";
            const KarrasNode node = karras_node(array, number);
            const int split = split_by_definition(codes, first, last);
            ASSERT_TRUE(node.first == first && node.last == last && node.split == split)
                << fmt::format(
                       "{} leaves: node {} covers leaves {} to {}, split behind {}; it should "
                       "cover {} to {}, split behind {}, where the first bit changes that not "
                       "all of them share",
                       n, number, node.first, node.last, node.split, first, last, split);
            if (!node.left_is_leaf()) open.push_back({first, split}), numbers.push_back(split);
            if (!node.right_is_leaf())
                open.push_back({split + 1, last}), numbers.push_back(split + 1);
        }
        EXPECT_EQ(nodes, n - 1);
    }
}

BvhTree build(const std::vector<Triangle>& triangles) {
    const DeviceArray<Triangle> on_device(triangles);
    return to_host(build_lbvh({on_device.data(), int(triangles.size())}));
}

TEST(Task4_5, EveryLeafHangsInTheTreeOnce) {
    const BvhTree tree = build(soup(5000, 0.05f));
    std::set<int> leaves;
    std::vector<int> open = {0};
    std::size_t nodes = 0;
    while (!open.empty()) {
        const int at = open.back();
        open.pop_back();
        ASSERT_LE(++nodes, tree.nodes.size()) << "the nodes' children go round in circles";
        for (const int child : tree.nodes[at].child) {
            if (is_leaf(child)) {
                EXPECT_TRUE(leaves.insert(~child).second)
                    << "leaf " << ~child << " hangs in two places";
                continue;
            }
            EXPECT_EQ(tree.nodes[child].parent, at);
            open.push_back(child);
        }
    }
    EXPECT_EQ(leaves.size(), tree.packs.size());
    EXPECT_LE(tree.depth, max_bvh_depth);
}

Bounds box_of(const TrianglePack& pack) {
    Bounds box;
    for (int lane = 0; lane < triangles_per_pack; ++lane)
        for (int corner = 0; pack.index[lane] >= 0 && corner < 3; ++corner)
            box.include(
                {pack.v[corner][0][lane], pack.v[corner][1][lane], pack.v[corner][2][lane]});
    return box;
}

// The box around all that is below, by recursion.
Bounds true_box(const BvhTree& tree, int child) {
    if (is_leaf(child)) return box_of(tree.packs[~child]);
    Bounds box = true_box(tree, tree.nodes[child].child[0]);
    box.include(true_box(tree, tree.nodes[child].child[1]));
    return box;
}

TEST(Task4_6, BoxesFitWhatIsBelowThem) {
    const BvhTree tree = build(soup(3000, 0.05f));
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        for (int side = 0; side < 2; ++side) {
            const Bounds truth = true_box(tree, tree.nodes[i].child[side]);
            for (int axis = 0; axis < 3; ++axis) {
                const float low = tree.nodes[i].box[axis][0][side],
                            high = tree.nodes[i].box[axis][1][side];
                ASSERT_TRUE(low == truth.low[axis] && high == truth.high[axis]) << fmt::format(
                    "the box of child {} of node {} reaches from {} to {} on axis {}; "
                    "what is below it reaches from {} to {}. A box is right once both "
                    "children below have written theirs",
                    side, i, low, high, axis, truth.low[axis], truth.high[axis]);
            }
        }
    }
}

TEST(Lbvh, RaysFindWhatBruteForceFinds) {
    std::vector<Triangle> same;
    for (int i = 0; i < 3000; ++i) add(same, {0, 0, 0}, {1, 0, 1}, {0, 1, 0.5f});
    for (const auto& [what, triangles] : {std::pair{"soup", soup(1000, 0.3f)},
                                          {"hills", hills(24)},
                                          {"city", city(8)},
                                          {"same", same},
                                          {"five", soup(5, 1)},
                                          {"eight", soup(8, 1)},
                                          {"one", soup(1, 2)}}) {
        const BvhTree tree = build(triangles);
        const Leaves leaves{{tree.packs.data(), int(tree.packs.size())},
                            {triangles.data(), int(triangles.size())}};
        const BvhView view{{tree.nodes.data(), int(tree.nodes.size())}};
        for (const Ray& ray : any_rays(triangles.size() > 2000 ? 300 : 2000)) {
            const Answer truth = brute_force(triangles, ray);
            ClosestHit closest(leaves, ray);
            walk_bvh_stack(view, closest);
            AnyHit any(leaves, ray);
            walk_bvh_stack(view, any);
            ASSERT_EQ(closest.hit().id, truth.id) << what;
            ASSERT_EQ(std::bit_cast<int>(closest.hit().t), std::bit_cast<int>(truth.t)) << what;
            ASSERT_EQ(any.found(), truth.any) << what;
        }
    }
}

TEST(Lbvh, TrianglesThatAreNoneAreLeftOut) {
    std::vector<Triangle> triangles = soup(100, 0.3f);
    add(triangles, Vec3(std::numeric_limits<float>::quiet_NaN()), {1, 0, 0}, {0, 1, 0});
    add(triangles, {0, infinity, 0}, {1, 0, 0}, {0, 1, 0});
    const BvhTree with = build(triangles);
    std::set<int> indices;
    for (const TrianglePack& pack : with.packs)
        for (const int index : pack.index)
            if (index >= 0) indices.insert(index);
    EXPECT_EQ(indices.size(), 100u);
    EXPECT_EQ(*indices.rbegin(), 99);
}

TEST(RadixSort, IsStable) {
    for (const int n : {0, 1, 31, 1023, 1024, 1025, 20000}) {
        Dice dice(n + 1);
        std::vector<std::uint32_t> keys(n);
        for (std::uint32_t& key : keys)
            key = dice.below(3) == 0 ? dice.below(5) : dice.below(1 << 30);
        std::vector<int> order(n);
        std::iota(order.begin(), order.end(), 0);
        DeviceArray<std::uint32_t> device_keys(keys);
        DeviceArray<int> device_order(order);
        radix_sort(device_keys, device_order, 31);
        std::stable_sort(order.begin(), order.end(),
                         [&](int a, int b) { return keys[a] < keys[b]; });
        EXPECT_EQ(device_order.to_host(), order) << n;
        std::sort(keys.begin(), keys.end());
        EXPECT_EQ(device_keys.to_host(), keys) << n;
    }
}

} // namespace

} // namespace raylab::lab04
