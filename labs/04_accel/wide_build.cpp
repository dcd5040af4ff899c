// From two children a node to eight: Ylitie, Karras and Laine 2017, section 3.
#include "labs/04_accel/wide_tree.h"

#include "labs/04_accel/build_items.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace raylab::lab04 {
namespace {

struct Candidate {
    int child; // of the binary tree
    Bounds box;
};

struct Collapse {
    const BvhTree& from;
    WideTree tree;
    std::vector<int> height; // of each binary node: levels of nodes below it, itself included

    Candidate child_of(int node, int k) const {
        const BvhNode& n = from.nodes[node];
        Candidate c{n.child[k], {}};
        for (int a = 0; a < 3; ++a) {
            (&c.box.low.x)[a] = n.box[a][0][k];
            (&c.box.high.x)[a] = n.box[a][1][k];
        }
        return c;
    }

    int height_of(const Candidate& c) const { return is_leaf(c.child) ? 0 : height[c.child]; }

    // Up to eight descendants of a binary node: the one whose box has the largest area is replaced
    // by its children, again and again. A chain so long that the levels might not suffice is
    // shortened first: three binary levels fit into one.
    std::vector<Candidate> descendants(int node, int level) const {
        std::vector<Candidate> found = {child_of(node, 0), child_of(node, 1)};
        std::erase_if(found, [](const Candidate& c) { return c.child == no_child; });
        const int allowed = 3 * (max_wide_levels - level - 1); // height below this node
        while (found.size() < wide_children) {
            const auto urgency = [&](const Candidate& c) {
                if (is_leaf(c.child)) return -1.0;
                return height_of(c) > allowed ? double(infinity) : half_area(c.box);
            };
            const auto best = std::max_element(
                found.begin(), found.end(),
                [&](const Candidate& a, const Candidate& b) { return urgency(a) < urgency(b); });
            if (is_leaf(best->child)) break;
            const int opened = best->child;
            *best = child_of(opened, 0);
            found.push_back(child_of(opened, 1));
        }
        return found;
    }

    // Which child goes to which slot: the pair of child and direction that agree best is settled
    // first.
    static std::array<int, wide_children> slots_for(const std::vector<Candidate>& children,
                                                    const Bounds& box) {
        std::array<int, wide_children> slot_child;
        slot_child.fill(-1);
        std::vector<bool> placed(children.size(), false);
        const Vec3 middle = 0.5f * box.low + 0.5f * box.high;
        for (std::size_t round = 0; round < children.size(); ++round) {
            float best = -infinity;
            int best_slot = 0, best_child = 0;
            for (std::size_t c = 0; c < children.size(); ++c) {
                if (placed[c]) continue;
                const Vec3 from_middle =
                    0.5f * children[c].box.low + 0.5f * children[c].box.high - middle;
                for (int slot = 0; slot < wide_children; ++slot) {
                    if (slot_child[slot] >= 0) continue;
                    float agreement = 0;
                    for (int axis = 0; axis < 3; ++axis)
                        agreement += (slot >> axis & 1 ? 1 : -1) * (&from_middle.x)[axis];
                    if (agreement > best) {
                        best = agreement;
                        best_slot = slot;
                        best_child = static_cast<int>(c);
                    }
                }
            }
            slot_child[best_slot] = best_child;
            placed[best_child] = true;
        }
        return slot_child;
    }

    // One step for all axes: a box is long on one of them, and there a step is a thousandth of it.
    static void set_grid(WideNode& node, const Bounds& box) {
        node.origin = box.low;
        double extent = 0;
        for (int axis = 0; axis < 3; ++axis)
            extent = std::max(extent, double((&box.high.x)[axis]) - (&box.low.x)[axis]);
        int exponent = -126;
        if (extent > 0)
            std::frexp(extent / last_face, &exponent); // extent / last_face <= 2^exponent
        node.step = std::ldexp(1.0f, std::max(exponent, -126));
    }

    static void set_faces(WideNode& node, int slot, const Bounds& box) {
        std::uint32_t q[3][2];
        for (int axis = 0; axis < 3; ++axis) {
            const double origin = (&node.origin.x)[axis];
            const double low = ((&box.low.x)[axis] - origin) / node.step,
                         high = ((&box.high.x)[axis] - origin) / node.step;
            q[axis][0] =
                static_cast<std::uint32_t>(std::clamp<double>(std::floor(low), 0, last_face));
            q[axis][1] =
                static_cast<std::uint32_t>(std::clamp<double>(std::ceil(high), 0, last_face));
        }
        node.face[0][slot] = q[0][0] | q[0][1] << face_bits | q[2][0] << 2 * face_bits;
        node.face[1][slot] = q[1][0] | q[1][1] << face_bits | q[2][1] << 2 * face_bits;
    }

    void fill(int self, int binary, int parent, int level) {
        tree.levels = std::max(tree.levels, level + 1);
        const std::vector<Candidate> children = descendants(binary, level);
        Bounds box;
        for (const Candidate& c : children) box.include(c.box);
        for (int axis = 0; axis < 3; ++axis)
            (&tree.extent.x)[axis] =
                std::max({(&tree.extent.x)[axis], std::fabs((&box.low.x)[axis]),
                          std::fabs((&box.high.x)[axis])});
        WideNode node{};
        set_grid(node, box);
        node.parent = parent;
        node.first_child = static_cast<int>(tree.nodes.size());
        node.first_block = static_cast<int>(tree.blocks.size());
        const auto slot_child = slots_for(children, box);
        std::vector<int> inner;
        for (int slot = 0; slot < wide_children; ++slot) {
            if (slot_child[slot] < 0) continue;
            const Candidate& c = children[slot_child[slot]];
            set_faces(node, slot, c.box);
            if (is_leaf(c.child)) {
                node.leaf |= 1 << slot;
                tree.blocks.push_back(from.blocks[~c.child]);
            } else {
                node.inner |= 1 << slot;
                inner.push_back(c.child);
            }
        }
        tree.nodes.resize(tree.nodes.size() + inner.size());
        tree.nodes[self] = node;
        for (std::size_t i = 0; i < inner.size(); ++i)
            fill(node.first_child + static_cast<int>(i), inner[i], self, level + 1);
    }

    void measure_heights() {
        height.resize(from.nodes.size());
        for (int i = static_cast<int>(from.nodes.size()) - 1; i >= 0; --i) // children come later
            for (const int child : from.nodes[i].child)
                height[i] = std::max(height[i], 1 + (is_leaf(child) ? 0 : height[child]));
    }
};

} // namespace

WideTree build_wide(const BvhTree& tree) {
    if (tree.nodes.empty()) return {};
    Collapse collapse{tree, {}, {}};
    collapse.measure_heights();
    collapse.tree.nodes.resize(1);
    collapse.fill(0, 0, -1, 0);
    return std::move(collapse.tree);
}

} // namespace raylab::lab04
