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

// Does the neighbour end where the cell's face is?
bool touches(const Bounds& neighbour, const Bounds& cell, int face) {
    const int axis = face / 2;
    return face % 2 == 0 ? neighbour.high[axis] == cell.low[axis]
                         : neighbour.low[axis] == cell.high[axis];
}

// Do the cell's face and the neighbour touch, and does the neighbour cover all of the face?
bool covers(const Bounds& neighbour, const Bounds& cell, int face) {
    for (int axis = 0; axis < 3; ++axis)
        if (axis != face / 2 &&
            !(neighbour.low[axis] <= cell.low[axis] && neighbour.high[axis] >= cell.high[axis]))
            return false;
    return touches(neighbour, cell, face);
}

// So many levels below the rope's end there is still a node that covers all of the face.
int levels_left(const KdTree& tree, const std::vector<Bounds>& cells, int rope, const Bounds& cell,
                int face) {
    for (int levels = 0;; ++levels) {
        const KdNode& end = tree.nodes[rope];
        if (end.is_leaf()) return levels;
        if (covers(cells[end.below()], cell, face))
            rope = end.below();
        else if (covers(cells[end.above()], cell, face))
            rope = end.above();
        else
            return levels;
    }
}

std::string face_name(int face) {
    return fmt::format("{} {} face", face % 2 == 0 ? "lower" : "upper", char('x' + face / 2));
}

TEST(Task4_2, RopesLeadToWhatLiesBehindTheFace) {
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
                                "the rope at the {} of a leaf {}; the likely cause: a child takes "
                                "its parent's ropes, and only at the face to its sibling another; "
                                "siblings are tied to each other at the wrong face",
                                face_name(face),
                                outer ? "should be none, for the scene ends there" : "is missing")))
                    return;
                if (outer) continue;
                if (!expect(touches(cells[rope], leaf.cell, face),
                            fmt::format("the rope at the {} of a leaf leads to a cell that does "
                                        "not touch that face; the likely cause: siblings are tied "
                                        "to each other at the wrong face, or a rope is pushed down "
                                        "to the child that does not touch the face",
                                        face_name(face))) ||
                    !expect(covers(cells[rope], leaf.cell, face),
                            fmt::format("the rope at the {} of a leaf leads to a cell that does "
                                        "not lie behind all of that face; the likely cause: a rope "
                                        "is pushed down to a child that covers a part",
                                        face_name(face))))
                    return;
            }
        }
    }
}

// A rope that ends at a larger node is right, too, but costs a step for each level.
TEST(Task4_2, RopesArePushedDown) {
    const KdCase scene(hills(40), deep());
    const KdTree& tree = scene.tree;
    std::vector<Bounds> cells(tree.nodes.size());
    find_cells(tree, 0, tree.bounds, cells);
    double levels = 0, ropes = 0;
    for (const KdLeaf& leaf : tree.leaves)
        for (int face = 0; face < 6; ++face) {
            const int rope = leaf.rope[face];
            if (rope == no_rope || !covers(cells[rope], leaf.cell, face)) continue;
            ++ropes;
            levels += levels_left(tree, cells, rope, leaf.cell, face);
        }
    levels /= std::fmax(ropes, 1);
    expect(levels <= 1, fmt::format("a rope ends {:.2f} levels above the smallest node that covers "
                                    "its face, on average; at most 1 is allowed; the likely cause: "
                                    "ropes are not pushed down",
                                    levels));
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
