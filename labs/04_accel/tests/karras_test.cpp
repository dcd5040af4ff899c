// Task 4.5: the hierarchy over sorted codes.
#include "common/task/facts.h"
#include "labs/04_accel/lbvh/karras.h"
#include "labs/04_accel/tests/cases.h"
#include "labs/04_accel/tests/lbvh_cases.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace raylab::lab04 {

namespace {

using namespace task;

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

// Which nodes cut_kernel() keeps and where leaves begin follows from the packs and their number.
TEST(Task4_5, EveryLeafHangsInTheTreeOnce) {
    const std::vector<Triangle> triangles = soup(5000, 0.05f);
    const BvhTree tree = build_from_codes(triangles);
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
    const BvhTree tree = build_from_codes(triangles);
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

} // namespace

} // namespace raylab::lab04
