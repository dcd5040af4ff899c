// From two children a node to eight: which descendants of a binary node become the children of a
// wide one? Those for which a ray pays least, found from the leaves up by dynamic programming.
// Ylitie, Karras and Laine 2017, section 3.
#include "labs/04_accel/wide_tree.h"

#include "labs/04_accel/build_items.h"
#include "labs/04_accel/bvh_sah.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace raylab::lab04 {
namespace {

constexpr double node_cost = 1, block_cost = 0.8; // of a visit

// What a binary subtree costs at best if it hangs in its parent as at most i + 1 children: a leaf
// or a node (i = 0), or a forest of several.
struct Forest {
    std::array<double, wide_children - 1> cost;
    std::array<std::uint8_t, wide_children> from_left; // of i + 1 children, i = 7: of a node
    int height;                                        // binary nodes from here to the deepest one
};

struct Candidate {
    int child; // of the binary tree
    Bounds box;
};

struct Collapse {
    const BvhTree& from;
    WideTree tree;
    std::vector<Forest> forest; // of each binary node

    Candidate child_of(int node, int k) const {
        return {from.nodes[node].child[k], child_box(from.nodes[node], k)};
    }

    int height_of(const Candidate& c) const {
        return is_leaf(c.child) ? 0 : forest[c.child].height;
    }

    double cost(const Candidate& c, int children) const {
        if (c.child == no_child) return 0;
        return is_leaf(c.child) ? half_area(c.box) * block_cost
                                : forest[c.child].cost[children - 1];
    }

    // From the leaves up: the cheapest way to share out n places among two subtrees.
    void plan() {
        forest.resize(from.nodes.size());
        for (int i = static_cast<int>(from.nodes.size()) - 1; i >= 0; --i) { // children come later
            const Candidate left = child_of(i, 0), right = child_of(i, 1);
            Bounds box = left.box;
            box.include(right.box);
            Forest& plan = forest[i];
            plan.height = 1 + std::max(height_of(left), height_of(right));
            double shared[wide_children + 1];
            for (int n = 2; n <= wide_children; ++n) {
                shared[n] = infinity;
                for (int k = 1; k < n; ++k) {
                    const double c = cost(left, k) + cost(right, n - k);
                    if (c < shared[n]) {
                        shared[n] = c;
                        plan.from_left[n - 1] = static_cast<std::uint8_t>(k);
                    }
                }
            }
            plan.cost[0] = half_area(box) * node_cost + shared[wide_children];
            plan.from_left[0] = 0;
            for (int n = 2; n < wide_children; ++n) {
                plan.cost[n - 1] = shared[n];
                if (plan.cost[n - 2] <= shared[n])
                    plan.cost[n - 1] = plan.cost[n - 2]; // fewer will do
            }
        }
    }

    // How a node's children are chosen: by the plan, or, where a chain of nodes might need more
    // levels than there are, evenly: three binary levels are one wide one.
    enum class Choice { planned, even };

    // The children that a subtree with this many places is made into, from near to far for rays of
    // the octant: at each binary node the lower child comes first, unless they go down the axis.
    void gather(const Candidate& c, int places, Choice choice, int octant,
                std::vector<Candidate>& found) const {
        if (c.child == no_child) return;
        if (!is_leaf(c.child)) {
            const auto& cost = forest[c.child].cost;
            while (choice == Choice::planned && places > 1 && cost[places - 2] <= cost[places - 1])
                --places; // fewer will do
            if (places > 1) return gather_both(c.child, places, choice, octant, found);
        }
        found.push_back(c);
    }

    void gather_both(int node, int places, Choice choice, int octant,
                     std::vector<Candidate>& found) const {
        const int left = choice == Choice::even ? places / 2 : forest[node].from_left[places - 1];
        const int first = octant >> from.nodes[node].axis & 1;
        for (const int k : {first, 1 - first})
            gather(child_of(node, k), k == 0 ? left : places - left, choice, octant, found);
    }

    std::vector<Candidate> children_of(int node, Choice choice, int octant) const {
        std::vector<Candidate> found;
        gather_both(node, wide_children, choice, octant, found);
        return found;
    }

    // By induction no subtree in level k is higher than 3 (max_wide_levels - k) binary levels.
    Choice choose(int node, int level) const {
        const int allowed = 3 * (max_wide_levels - level - 1);
        for (const Candidate& c : children_of(node, Choice::planned, 0))
            if (!is_leaf(c.child) && forest[c.child].height > allowed) return Choice::even;
        return Choice::planned;
    }

    // The slots of the children (in the order of octant 0) in the order of another octant.
    std::uint32_t order_of(int node, Choice choice, int octant,
                           const std::vector<Candidate>& children) const {
        std::uint32_t order = 0;
        int place = 0;
        for (const Candidate& c : children_of(node, choice, octant)) {
            const auto same = [&](const Candidate& other) { return other.child == c.child; };
            const auto slot =
                std::find_if(children.begin(), children.end(), same) - children.begin();
            order |= static_cast<std::uint32_t>(slot) << 3 * place++;
        }
        return order;
    }

    // One step for all axes: a box is long on one of them, and there a step is a thousandth of it.
    static void set_grid(WideNode& node, const Bounds& box) {
        node.origin = box.low;
        double extent = 0;
        for (int axis = 0; axis < 3; ++axis)
            extent = std::max(extent, double(box.high[axis]) - box.low[axis]);
        int exponent = -126;
        if (extent > 0)
            std::frexp(extent / last_face, &exponent); // extent / last_face <= 2^exponent
        node.step = std::ldexp(1.0f, std::max(exponent, -126));
    }

    static void set_faces(WideNode& node, int slot, const Bounds& box) {
        std::uint32_t q[3][2];
        for (int axis = 0; axis < 3; ++axis) {
            const double origin = node.origin[axis];
            const double low = (box.low[axis] - origin) / node.step,
                         high = (box.high[axis] - origin) / node.step;
            q[axis][0] =
                static_cast<std::uint32_t>(std::clamp<double>(std::floor(low), 0, last_face));
            q[axis][1] =
                static_cast<std::uint32_t>(std::clamp<double>(std::ceil(high), 0, last_face));
        }
        node.face[0][slot] = q[0][0] | q[0][1] << face_bits | q[2][0] << 2 * face_bits;
        node.face[1][slot] = q[1][0] | q[1][1] << face_bits | q[2][1] << 2 * face_bits;
    }

    static_assert(3 * max_wide_levels >= max_sah_depth);

    void fill(int self, int binary, int parent, int level) {
        tree.levels = std::max(tree.levels, level + 1);
        const Choice choice = choose(binary, level);
        const std::vector<Candidate> children = children_of(binary, choice, 0);
        Bounds box;
        for (const Candidate& c : children) box.include(c.box);
        for (int axis = 0; axis < 3; ++axis)
            tree.extent[axis] =
                std::max({tree.extent[axis], std::fabs(box.low[axis]), std::fabs(box.high[axis])});
        WideNode node{};
        set_grid(node, box);
        node.parent = parent;
        node.first_child = static_cast<int>(tree.nodes.size());
        node.first_block = static_cast<int>(tree.blocks.size());
        for (int octant = 0; octant < 8; ++octant)
            node.order[octant] = order_of(binary, choice, octant, children);
        std::vector<int> inner;
        for (std::size_t slot = 0; slot < children.size(); ++slot) {
            const Candidate& c = children[slot];
            set_faces(node, static_cast<int>(slot), c.box);
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
};

} // namespace

WideTree build_wide(const BvhTree& tree) {
    if (tree.nodes.empty()) return {};
    Collapse collapse{tree, {}, {}};
    collapse.plan();
    collapse.tree.nodes.resize(1);
    collapse.fill(0, 0, -1, 0);
    return std::move(collapse.tree);
}

} // namespace raylab::lab04
