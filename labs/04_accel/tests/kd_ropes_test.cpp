// Task 4.2: a rope leads from a face of a leaf to the smallest node behind all of it.
#include "common/task/facts.h"
#include "labs/04_accel/tests/kd_cases.h"

namespace raylab::lab04 {

namespace {

using namespace task;

// By node.
void find_cells(const KdTree& tree, int at, const Bounds& cell, std::vector<Bounds>& cells) {
    cells[at] = cell;
    const KdNode& node = tree.nodes[at];
    if (node.is_leaf()) return;
    Bounds low = cell, high = cell;
    low.high[node.axis()] = high.low[node.axis()] = node.split;
    find_cells(tree, node.below(), low, cells);
    find_cells(tree, node.above(), high, cells);
}

// Do the cell's face and the neighbour touch, and does the neighbour cover all of the face?
bool covers(const Bounds& neighbour, const Bounds& cell, int face) {
    for (int axis = 0; axis < 3; ++axis) {
        const float begin = cell.low[axis], end = cell.high[axis];
        const float n_low = neighbour.low[axis], n_high = neighbour.high[axis];
        const bool touches = face % 2 == 0 ? n_high == begin : n_low == end;
        if (axis == face / 2 ? !touches : !(n_low <= begin && n_high >= end)) return false;
    }
    return true;
}

std::string face_name(int face) {
    return fmt::format("{} {} face", face % 2 == 0 ? "lower" : "upper", char('x' + face / 2));
}

TEST(Task4_2, RopesLeadToTheSmallestNeighbour) {
    for (const auto& triangles : {hills(12), soup(300, 0.3f), on_grid(400)}) {
        const KdCase scene(triangles, deep());
        const KdTree& tree = scene.tree;
        std::vector<Bounds> cells(tree.nodes.size());
        find_cells(tree, 0, tree.bounds, cells);
        for (const KdLeaf& leaf : tree.leaves) {
            for (int face = 0; face < 6; ++face) {
                const int axis = face / 2;
                const bool outer = face % 2 == 0 ? leaf.cell.low[axis] == tree.bounds.low[axis]
                                                 : leaf.cell.high[axis] == tree.bounds.high[axis];
                const int rope = leaf.rope[face];
                if (!expect((rope == no_rope) == outer,
                            fmt::format(
                                "the rope at the {} of a leaf {}; the likely cause: a child "
                                "takes its parent's ropes, but for the face to its sibling",
                                face_name(face),
                                outer ? "should be none, for the scene ends there" : "is missing")))
                    return;
                if (outer) continue;
                if (!expect(
                        covers(cells[rope], leaf.cell, face),
                        fmt::format("the rope at the {} of a leaf leads to a cell that does not "
                                    "lie behind all of that face; the likely cause: siblings "
                                    "are tied to each other at the wrong face, or a rope is "
                                    "pushed down to a child that covers a part",
                                    face_name(face))))
                    return;
                const KdNode& end = tree.nodes[rope];
                const bool smaller =
                    !end.is_leaf() && (covers(cells[end.below()], leaf.cell, face) ||
                                       covers(cells[end.above()], leaf.cell, face));
                if (!expect(!smaller,
                            fmt::format("the rope at the {} of a leaf ends at a node one of whose "
                                        "children covers the face, too; the likely cause: ropes "
                                        "are not pushed down to the end",
                                        face_name(face))))
                    return;
            }
        }
    }
}

TEST(Task4_2, EveryLeafHasItsCellAndRopes) {
    const KdCase scene(hills(12), deep());
    const KdTree& tree = scene.tree;
    std::vector<Bounds> cells(tree.nodes.size());
    find_cells(tree, 0, tree.bounds, cells);
    for (std::size_t node = 0; node < tree.nodes.size(); ++node) {
        const int leaf = tree.leaf_of[node];
        if (!expect((leaf >= 0) == tree.nodes[node].is_leaf(), "a leaf without ropes")) return;
        if (leaf < 0) continue;
        const Bounds& cell = tree.leaves[leaf].cell;
        if (!expect(cell.low == cells[node].low && cell.high == cells[node].high,
                    "a leaf's cell is not where the planes above it put it"))
            return;
    }
}

} // namespace

} // namespace raylab::lab04
