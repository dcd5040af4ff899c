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
#include "labs/04_accel/tests/refit_arrivals.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <numeric>
#include <set>

namespace raylab::lab04 {

namespace {

using namespace task;

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

TEST(Task4_4, SpreadPutsTwoZerosInFrontOfEachBit) {
    for (int bit = 0; bit < morton_bits; ++bit)
        if (!expect_equal(fmt::format("spread() of bit {} alone: the number", bit),
                          spread(1u << bit), 1ll << 3 * bit,
                          "a mask of spread() loses this bit, or a move is left out or goes too "
                          "far"))
            return;
}

TEST(Task4_4, CodesAreTheBitsOfThreeCoordinatesInTurns) {
    expect_equal("the code of cell (1, 0, 0)", morton_code(centre_of_cell(1, 0, 0), unit_cube), 4,
                 "x y z in turns, x highest in each group of three bits");
    Dice dice(1);
    for (int i = 0; i < 10000; ++i) {
        const int x = dice.below(1024), y = dice.below(1024), z = dice.below(1024);
        const std::uint32_t code = morton_code(centre_of_cell(x, y, z), unit_cube);
        if (!expect(code == code_of_cells(x, y, z),
                    fmt::format("the code of cell ({}, {}, {}) of 1024 on each axis should be "
                                "{:030b} but is {:030b}; the likely cause: the bits of x, y and z "
                                "in turns, x highest, of the cell that floor(1024 share) is",
                                x, y, z, code_of_cells(x, y, z), code)))
            return;
    }
}

TEST(Task4_4, ABoxMayLieAnywhere) {
    const Bounds box{Vec3(-3, 5, 100), Vec3(-1, 9, 101)};
    expect_equal("the code of the lower corner of a box that does not begin at 0",
                 morton_code(box.low, box), 0,
                 "how far p is on its way through the box: from "
                 "box.low, by the box's extent");
    const Vec3 middle = 0.5f * (box.low + box.high);
    expect_equal("the code of its middle", morton_code(middle, box), 7 << 3 * (morton_bits - 1),
                 "how far p is on its way through the box: from box.low, by the box's extent");
}

TEST(Task4_4, PointsOnAndOutsideTheBoxAreInItsOuterCells) {
    const std::uint32_t last = (1u << 3 * morton_bits) - 1;
    expect_equal("the code of the near corner", morton_code(Vec3(0), unit_cube), 0,
                 "it is in the first cell");
    expect_equal("the code of the far corner", morton_code(Vec3(1), unit_cube), last,
                 "what lies on the far face is in the last cell, 1023, not in cell 1024");
    expect_equal("the code of a point before the box", morton_code(Vec3(-5), unit_cube), 0,
                 "what lies outside is in the first cell, or in the last cell");
    expect_equal("the code of a point behind the box", morton_code(Vec3(7), unit_cube), last,
                 "what lies outside is in the first cell, or in the last cell");
}

TEST(Task4_4, AFlatBoxHasCodes) {
    const Bounds floor{Vec3(0), Vec3(1, 0, 1)};
    expect_equal("the code of a point in a box without height",
                 morton_code(Vec3(0.999f, 0, 0), floor), code_of_cells(1022, 0, 0),
                 "on an axis without extent all are in cell 0: 0 / 0 is no number");
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
            if (!expect(nodes++ < n, "the children of karras_node() go round in circles")) return;
            const KarrasNode node = karras_node(array, number);
            const std::string what = fmt::format("of {} leaves, node {} ", n, number);
            const bool up = number == first;
            if (!expect((up ? node.first : node.last) == number,
                        fmt::format("{}should cover leaves {} to {} but covers {} to {}; the "
                                    "likely cause: the range goes from i to the side of the "
                                    "neighbour that is closer, that shares more bits with it",
                                    what, first, last, node.first, node.last)) ||
                !expect(node.first == first && node.last == last,
                        fmt::format("{}should cover leaves {} to {} but covers {} to {}; the "
                                    "likely cause: the range ends at the last leaf that shares "
                                    "more bits with i than the neighbour on the other side does",
                                    what, first, last, node.first, node.last)))
                return;
            const int split = split_by_definition(codes, first, last);
            if (!expect_equal(fmt::format("{}covers leaves {} to {}; its split", what, first, last),
                              node.split, split,
                              up ? "the left half ends at the last leaf that shares more bits with "
                                   "leaf i than the whole range does"
                                 : "the right half of a range that goes down begins at the last "
                                   "leaf that shares more bits with leaf i than the whole range "
                                   "does, and split is where the left half ends"))
                return;
            if (!node.left_is_leaf()) open.push_back({first, split}), numbers.push_back(split);
            if (!node.right_is_leaf())
                open.push_back({split + 1, last}), numbers.push_back(split + 1);
        }
        expect_equal(fmt::format("nodes that hang below the root, of {} leaves", n), nodes, n - 1,
                     "a child that covers more than one leaf is a node");
    }
}

BvhTree build(const std::vector<Triangle>& triangles) {
    const DeviceArray<Triangle> on_device(triangles);
    return to_host(build_lbvh({on_device.data(), int(triangles.size())}));
}

// Which nodes cut_kernel() keeps and where leaves begin follows from the packs and their number.
TEST(Task4_5, EveryLeafHangsInTheTreeOnce) {
    const std::vector<Triangle> triangles = soup(5000, 0.05f);
    const BvhTree tree = build(triangles);
    std::vector<int> places(triangles.size());
    for (const TrianglePack& pack : tree.packs)
        for (const int index : pack.index)
            if (index >= 0) ++places[index];
    const auto lost = std::count(places.begin(), places.end(), 0);
    if (!expect_equal("triangles of 5000 that are in no leaf", lost, 0,
                      "cut_kernel() must mark where each leaf begins: at the first triangle of a "
                      "left child that fits into a pack, and of a right one") ||
        !expect_equal("nodes of a tree, more than its leaves",
                      static_cast<long long>(tree.nodes.size()) -
                          static_cast<long long>(tree.packs.size()),
                      -1,
                      "a node is kept if it has more triangles than a pack, and only then; its "
                      "children that fit into a pack are leaves"))
        return;
    std::set<int> leaves;
    std::vector<int> open = {0};
    std::size_t nodes = 0;
    while (!open.empty()) {
        const int at = open.back();
        open.pop_back();
        if (!expect(++nodes <= tree.nodes.size(),
                    "the nodes' children go round in circles; the likely cause: the left child is "
                    "the node of number split, the right one of number split + 1, by their new "
                    "numbers"))
            return;
        for (const int child : tree.nodes[at].child) {
            if (is_leaf(child)) {
                if (!expect(~child < static_cast<int>(tree.packs.size()) &&
                                leaves.insert(~child).second,
                            fmt::format("leaf {} of {} hangs in two places or is none; the likely "
                                        "cause: a leaf has the number of the place where it "
                                        "begins: its child's first triangle",
                                        ~child, tree.packs.size())))
                    return;
                continue;
            }
            if (!expect(child < static_cast<int>(tree.nodes.size()) &&
                            tree.nodes[child].parent == at,
                        fmt::format("node {}, a child of node {}, is none of its own; the likely "
                                    "cause: the left child is the node of number split, the right "
                                    "one of number split + 1, by their new numbers",
                                    child, at)))
                return;
            open.push_back(child);
        }
    }
    expect_equal("leaves that hang in the tree", static_cast<long long>(leaves.size()),
                 static_cast<long long>(tree.packs.size()),
                 "a child that fits into a pack is the leaf that begins at its first triangle");
    expect(tree.depth <= max_bvh_depth,
           fmt::format("the tree is {} nodes deep, more than {}", tree.depth, max_bvh_depth));
}

// The middle of the box around a triangle: what its code is made of.
Vec3 centre(const Triangle& triangle) {
    Bounds box;
    for (const Vec3& v : triangle.v) box.include(v);
    return 0.5f * box.low + 0.5f * box.high;
}

std::uint32_t code_by_definition(const Vec3& p, const Bounds& box) {
    int cell[3];
    for (int axis = 0; axis < 3; ++axis)
        cell[axis] = std::clamp(
            int((p[axis] - box.low[axis]) / (box.high[axis] - box.low[axis]) * 1024), 0, 1023);
    return code_of_cells(cell[0], cell[1], cell[2]);
}

// The centres of what is below, and their codes.
struct Below {
    Bounds centres;
    std::set<std::uint32_t> codes;

    void add(const BvhTree& tree, const std::vector<Triangle>& triangles, const Bounds& box,
             int child) {
        if (!is_leaf(child)) {
            for (const int next : tree.nodes[child].child) add(tree, triangles, box, next);
            return;
        }
        for (const int index : tree.packs[~child].index) {
            if (index < 0) continue;
            centres.include(centre(triangles[index]));
            codes.insert(code_by_definition(centre(triangles[index]), box));
        }
    }
};

// Walks take the children's order from it.
TEST(Task4_5, ChildrenLieApartOnTheNodesAxis) {
    const std::vector<Triangle> triangles = soup(1000, 0.05f);
    Bounds box;
    for (const Triangle& triangle : triangles) box.include(centre(triangle));
    for (const Triangle& triangle : triangles) // other codes are task 4.4's matter
        if (morton_code(centre(triangle), box) != code_by_definition(centre(triangle), box)) return;
    const BvhTree tree = build(triangles);
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        const BvhNode& node = tree.nodes[i];
        Below low, high;
        low.add(tree, triangles, box, node.child[0]);
        high.add(tree, triangles, box, node.child[1]);
        if (low.codes.empty() || high.codes.empty() || *low.codes.rbegin() == *high.codes.begin())
            continue;
        if (!expect(low.centres.high[node.axis] <= high.centres.low[node.axis],
                    fmt::format("the children of node {} do not lie apart on its axis, {}; the "
                                "likely cause: the axis is that of the first bit in which their "
                                "codes differ, split_axis()",
                                i, char('x' + node.axis))))
            return;
    }
}

Bounds box_of(const TrianglePack& pack) {
    Bounds box;
    for (int lane = 0; lane < triangles_per_pack; ++lane)
        for (int corner = 0; pack.index[lane] >= 0 && corner < 3; ++corner)
            box.include(
                {pack.v[corner][0][lane], pack.v[corner][1][lane], pack.v[corner][2][lane]});
    return box;
}

bool holds(const Bounds& outer, const Bounds& inner) {
    return glm::all(glm::lessThanEqual(outer.low, inner.low)) &&
           glm::all(glm::greaterThanEqual(outer.high, inner.high));
}

// The box around all that is below, by recursion.
Bounds true_box(const BvhTree& tree, int child) {
    if (is_leaf(child)) return box_of(tree.packs[~child]);
    Bounds box = true_box(tree, tree.nodes[child].child[0]);
    box.include(true_box(tree, tree.nodes[child].child[1]));
    return box;
}

// Whatever the order in which threads come to a node. far: how far the triangles lie from 0.
void expect_fitting_boxes(const Vec3& far) {
    std::vector<Triangle> triangles = soup(3000, 0.05f);
    for (Triangle& triangle : triangles)
        for (Vec3& v : triangle.v) v += far;
    const BvhTree tree = build(triangles);
    // From the leaves up, as the boxes are found: first those of leaves.
    for (std::size_t k = 0; k < 2 * tree.nodes.size(); ++k) {
        const std::size_t i = k % tree.nodes.size();
        for (int side = 0; side < 2; ++side) {
            const int child = tree.nodes[i].child[side];
            if (is_leaf(child) != (k < tree.nodes.size())) continue;
            const Bounds truth = true_box(tree, child), box = child_box(tree.nodes[i], side);
            const Bounds other = true_box(tree, tree.nodes[i].child[1 - side]);
            if (box.low == truth.low && box.high == truth.high) continue;
            const bool empty = glm::any(glm::greaterThan(box.low, box.high)) ||
                               (box.low == Vec3(0) && box.high == Vec3(0));
            const char* cause =
                empty || (box.low == other.low && box.high == other.high)
                    ? "a box is written on the side of the child that the thread comes from, which "
                      "on each level is another"
                : holds(box, truth)
                    ? "the box is begun around the origin, 0, and not with the leaf's box"
                : is_leaf(child) ? "the box of the thread's leaf comes first"
                                 : "the second of two threads goes on, when both children have "
                                   "written their boxes, with the union of both: box_in()";
            expect(false,
                   fmt::format("the box of child {} of node {} should reach from ({}, {}, {}) to "
                               "({}, {}, {}) but reaches from ({}, {}, {}) to ({}, {}, {}); the "
                               "likely cause: {}",
                               side, i, truth.low.x, truth.low.y, truth.low.z, truth.high.x,
                               truth.high.y, truth.high.z, box.low.x, box.low.y, box.low.z,
                               box.high.x, box.high.y, box.high.z, cause));
            return;
        }
    }
}

TEST(Task4_6, BoxesFitWhatIsBelowThem) { expect_fitting_boxes(Vec3(0)); }
TEST(Task4_6, BoxesFitFarFromTheOrigin) { expect_fitting_boxes(Vec3(10, 20, -30)); }

// Of two threads that come to a node one goes on: a tree of n leaves has 2 (n - 1) arrivals.
TEST(Task4_6, TheFirstOfTwoThreadsEnds) {
    const BvhTree tree = build(soup(500, 0.05f));
    const int leaves = int(tree.packs.size());
    std::vector<int> parents(leaves);
    for (std::size_t i = 0; i < tree.nodes.size(); ++i)
        for (const int child : tree.nodes[i].child)
            if (is_leaf(child)) parents[~child] = int(i);
    const std::vector<int> arrived = refit_arrivals(tree, parents);
    for (std::size_t i = 0; i < arrived.size(); ++i)
        if (!expect_equal(fmt::format("arrivals at node {}", i), arrived[i], 2,
                          "the first of the two threads ends here, when it has counted its "
                          "arrival, and the second goes on"))
            return;
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
