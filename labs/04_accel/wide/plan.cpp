#include "labs/04_accel/wide/plan.h"

#include "labs/04_accel/builder/items.h"

#include <algorithm>

namespace raylab::lab04 {
namespace {

constexpr double node_cost = 1, pack_cost = 0.8; // of a visit

} // namespace

WidePlan::WidePlan(const BvhTree& tree) : tree_(tree), forest_(tree.nodes.size()) {
    for (int i = static_cast<int>(tree.nodes.size()) - 1; i >= 0; --i) forest_[i] = plan(i);
}

WideChild WidePlan::child_of(int node, int k) const {
    return {tree_.nodes[node].child[k], child_box(tree_.nodes[node], k)};
}

int WidePlan::height_of(const WideChild& c) const {
    return is_leaf(c.child) ? 0 : forest_[c.child].height;
}

double WidePlan::cost(const WideChild& c, int children) const {
    if (c.child == no_child) return 0;
    return is_leaf(c.child) ? half_area(c.box) * pack_cost : forest_[c.child].cost[children - 1];
}

// The cheapest way to share out n places among the two subtrees, for each n.
WidePlan::Forest WidePlan::plan(int node) const {
    const WideChild left = child_of(node, 0), right = child_of(node, 1);
    Forest plan{{}, {}, 1 + std::max(height_of(left), height_of(right))};
    double shared[wide_children + 1];
    for (int n = 2; n <= wide_children; ++n) {
        shared[n] = infinity;
        for (int k = 1; k < n; ++k) {
            const double c = cost(left, k) + cost(right, n - k);
            if (c >= shared[n]) continue;
            shared[n] = c;
            plan.from_left[n - 1] = static_cast<std::uint8_t>(k);
        }
    }
    Bounds box = left.box;
    box.include(right.box);
    plan.cost[0] = half_area(box) * node_cost + shared[wide_children];
    for (int n = 2; n < wide_children; ++n) // cost of at most n, so fewer where they cost less
        plan.cost[n - 1] = std::min(shared[n], plan.cost[n - 2]);
    return plan;
}

void WidePlan::gather(const WideChild& c, int places, Choice choice, int octant,
                      std::vector<WideChild>& found) const {
    if (c.child == no_child) return;
    if (!is_leaf(c.child)) {
        const auto& cost = forest_[c.child].cost;
        while (choice == Choice::planned && places > 1 && cost[places - 2] <= cost[places - 1])
            --places; // fewer cost no more
        if (places > 1) return gather_both(c.child, places, choice, octant, found);
    }
    found.push_back(c);
}

void WidePlan::gather_both(int node, int places, Choice choice, int octant,
                           std::vector<WideChild>& found) const {
    const int left = choice == Choice::even ? places / 2 : forest_[node].from_left[places - 1];
    const int first = octant >> tree_.nodes[node].axis & 1;
    for (const int k : {first, 1 - first})
        gather(child_of(node, k), k == 0 ? left : places - left, choice, octant, found);
}

// By induction no subtree in level k is higher than 3 (max_wide_levels - k) binary levels.
WidePlan::Choice WidePlan::choose(int node, int level) const {
    static_assert(3 * max_wide_levels >= max_sah_depth);
    const int allowed = 3 * (max_wide_levels - level - 1);
    const std::vector<WideChild> planned = children(node, Choice::planned, 0);
    const bool too_high = std::any_of(planned.begin(), planned.end(),
                                      [&](const WideChild& c) { return height_of(c) > allowed; });
    return too_high ? Choice::even : Choice::planned;
}

std::vector<WideChild> WidePlan::children(int node, Choice choice, int octant) const {
    std::vector<WideChild> found;
    found.reserve(wide_children);
    gather_both(node, wide_children, choice, octant, found);
    return found;
}

} // namespace raylab::lab04
