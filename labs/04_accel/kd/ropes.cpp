// Laying the ropes; see kd/ropes.h.
//
// On the way down from the root every node gets six ropes. A child takes those of its parent, but
// the rope of the face between the two children leads to the other child. The node that a rope
// leads to may be much larger than the face. So the rope is pushed down, as long as one child alone
// covers the whole face.
#include "labs/04_accel/kd/ropes.h"

#include "common/task/not_implemented.h"

#include <array>

namespace raylab::lab04 {

namespace {

using Ropes = std::array<int, 6>; // by face, as KdLeaf::rope

class Layer {
  public:
    explicit Layer(KdTree& tree) : tree_(tree) {}

    void lay(int at, const Bounds& cell, Ropes ropes) {
        const KdNode node = tree_.nodes[at];
        for (int face = 0; face < 6; ++face) ropes[face] = pushed_down(ropes[face], face, cell);
        if (node.is_leaf()) {
            tree_.leaf_of[at] = int(tree_.leaves.size());
            KdLeaf& leaf = tree_.leaves.emplace_back();
            leaf.cell = cell;
            std::copy(ropes.begin(), ropes.end(), leaf.rope);
            return;
        }
        const int axis = node.axis();
        Bounds lower = cell, upper = cell;
        lower.high[axis] = upper.low[axis] = node.split;
        Ropes lower_ropes = ropes, upper_ropes = ropes;
        // Steps:
        // 1. The lower child's upper face across this axis leads to the upper child.
        // 2. The upper child's lower face leads to the lower child.
        //[ task 4.2
        lower_ropes[2 * axis + 1] = node.above();
        upper_ropes[2 * axis] = node.below();
        //| // To the root: right, but a long way down again.
        //| lower_ropes[2 * axis + 1] = upper_ropes[2 * axis] = 0;
        //]
        lay(node.below(), lower, lower_ropes);
        lay(node.above(), upper, upper_ropes);
    }

  private:
    // The smallest node in the subtree `rope` that still covers the whole face of the cell.
    int pushed_down(int rope, int face, const Bounds& cell) const {
        // Steps:
        // 1. Go down while the rope leads to an inner node.
        // 2. Its plane is across the face's axis: to the child that touches the face.
        // 3. Across another axis: to the child that covers the whole face; if neither does, stop.
        //[ task 4.2
        while (rope != no_rope && !tree_.nodes[rope].is_leaf()) {
            const KdNode& node = tree_.nodes[rope];
            const int axis = node.axis();
            if (axis == face / 2) {
                rope = face % 2 == 0 ? node.above() : node.below(); // the one beside the face
            } else if (node.split <= cell.low[axis]) {
                rope = node.above();
            } else if (node.split >= cell.high[axis]) {
                rope = node.below();
            } else {
                break;
            }
        }
        //| not_implemented("4.2", "lay_ropes()");
        //]
        return rope;
    }

    KdTree& tree_;
};

} // namespace

void lay_ropes(KdTree& tree) {
    tree.leaf_of.assign(tree.nodes.size(), -1);
    tree.leaves.clear();
    if (tree.nodes.empty()) return;
    Ropes none;
    none.fill(no_rope);
    Layer(tree).lay(0, tree.bounds, none);
}

} // namespace raylab::lab04
