#include "labs/04_accel/bvh/skip_tree.h"

#include "common/task/not_implemented.h"

namespace raylab::lab04 {
namespace {

// Appends what hangs in this place of the tree.
void append(const BvhTree& tree, int child, const Bounds& box, std::vector<SkipNode>& line) {
    if (child == no_child) return;
    const std::size_t self = line.size();
    line.push_back({box, 0, is_leaf(child) ? ~child : -1});
    if (!is_leaf(child)) {
        const BvhNode& node = tree.nodes[child];
        for (int k = 0; k < 2; ++k) append(tree, node.child[k], child_box(node, k), line);
    }
    line[self].skip = static_cast<int>(line.size());
}

} // namespace

std::vector<SkipNode> lay_skip_links(const BvhTree& tree) {
    std::vector<SkipNode> line;
    if (tree.nodes.empty()) return line;
    // Steps:
    // 1. Append what hangs in the root: its two children in order, each with its box.
    //[ task 4.7
    const BvhNode& root = tree.nodes[0];
    for (int k = 0; k < 2; ++k) append(tree, root.child[k], child_box(root, k), line);
    //| // Every leaf in a box that no ray misses: slow, and right.
    //| not_implemented("4.7", "lay_skip_links()");
    //| const Bounds everywhere{Vec3(-infinity), Vec3(infinity)};
    //| for (int pack = 0; pack < static_cast<int>(tree.packs.size()); ++pack)
    //|     line.push_back({everywhere, pack + 1, pack});
    //]
    return line;
}

} // namespace raylab::lab04
