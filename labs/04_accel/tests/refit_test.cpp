// Task 4.6: boxes, from the leaves up.
#include "common/task/facts.h"
#include "labs/04_accel/tests/cases.h"
#include "labs/04_accel/tests/lbvh_cases.h"
#include "labs/04_accel/tests/refit_arrivals.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace raylab::lab04 {

namespace {

using namespace task;

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
    const BvhTree tree = build_from_codes(triangles);
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
    const BvhTree tree = build_from_codes(soup(500, 0.05f));
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

} // namespace

} // namespace raylab::lab04
