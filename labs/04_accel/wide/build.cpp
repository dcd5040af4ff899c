// From a plan (wide/plan.h) to nodes with their grids, faces and orders.
#include "labs/04_accel/wide/plan.h"
#include "labs/04_accel/wide/tree.h"

#include <algorithm>
#include <cmath>

namespace raylab::lab04 {
namespace {

// All axes have the same step. The box is longest on one axis, and there a step is about a
// thousandth of it.
void set_grid(WideNode& node, const Bounds& box) {
    node.origin = box.low;
    double extent = 0;
    for (int axis = 0; axis < 3; ++axis)
        extent = std::max(extent, double(box.high[axis]) - box.low[axis]);
    int exponent = -126;
    if (extent > 0) std::frexp(extent / last_face, &exponent); // extent / last_face <= 2^exponent
    node.step = std::ldexp(1.0f, std::max(exponent, -126));
}

std::uint32_t face_at(double steps) {
    return static_cast<std::uint32_t>(std::clamp<double>(steps, 0, last_face));
}

// The slot's box on the grid, rounded outwards.
void set_faces(WideNode& node, int slot, const Bounds& box) {
    std::uint32_t low[3], high[3];
    for (int axis = 0; axis < 3; ++axis) {
        const double origin = node.origin[axis];
        low[axis] = face_at(std::floor((box.low[axis] - origin) / node.step));
        high[axis] = face_at(std::ceil((box.high[axis] - origin) / node.step));
    }
    node.face[0][slot] = low[0] | high[0] << face_bits | low[2] << 2 * face_bits;
    node.face[1][slot] = low[1] | high[1] << face_bits | high[2] << 2 * face_bits;
}

class Writer {
  public:
    explicit Writer(const BvhTree& from) : from_(from), plan_(from) { tree_.nodes.resize(1); }

    WideTree write() {
        write(0, 0, -1, 0);
        return std::move(tree_);
    }

  private:
    // Slots are numbered in the order of octant 0. Returns their numbers in the order of this
    // octant.
    std::uint32_t order_of(int binary, WidePlan::Choice choice, int octant,
                           const std::vector<WideChild>& slots) const {
        std::uint32_t order = 0;
        int place = 0;
        for (const WideChild& c : plan_.children(binary, choice, octant)) {
            const auto same = [&](const WideChild& other) { return other.child == c.child; };
            const auto slot = std::find_if(slots.begin(), slots.end(), same) - slots.begin();
            order |= static_cast<std::uint32_t>(slot) << 3 * place++;
        }
        return order;
    }

    void include(const Bounds& box) {
        for (int axis = 0; axis < 3; ++axis)
            tree_.extent[axis] =
                std::max({tree_.extent[axis], std::fabs(box.low[axis]), std::fabs(box.high[axis])});
    }

    // Node `self`, which stands for a binary one, and all below it.
    void write(int self, int binary, int parent, int level) {
        tree_.levels = std::max(tree_.levels, level + 1);
        const WidePlan::Choice choice = plan_.choose(binary, level);
        const std::vector<WideChild> slots = plan_.children(binary, choice, 0);
        Bounds box;
        for (const WideChild& c : slots) box.include(c.box);
        include(box);

        WideNode node{};
        set_grid(node, box);
        node.parent = parent;
        node.first_child = static_cast<int>(tree_.nodes.size());
        node.first_pack = static_cast<int>(tree_.packs.size());
        for (int octant = 0; octant < 8; ++octant)
            node.order[octant] = order_of(binary, choice, octant, slots);
        std::vector<int> inner;
        for (std::size_t slot = 0; slot < slots.size(); ++slot) {
            const WideChild& c = slots[slot];
            set_faces(node, static_cast<int>(slot), c.box);
            if (is_leaf(c.child)) {
                node.leaf |= 1 << slot;
                tree_.packs.push_back(from_.packs[~c.child]);
            } else {
                node.inner |= 1 << slot;
                inner.push_back(c.child);
            }
        }
        tree_.nodes.resize(tree_.nodes.size() + inner.size());
        tree_.nodes[self] = node;
        for (std::size_t i = 0; i < inner.size(); ++i)
            write(node.first_child + static_cast<int>(i), inner[i], self, level + 1);
    }

    const BvhTree& from_;
    WidePlan plan_;
    WideTree tree_;
};

} // namespace

WideTree build_wide(const BvhTree& tree) {
    return tree.nodes.empty() ? WideTree{} : Writer(tree).write();
}

} // namespace raylab::lab04
