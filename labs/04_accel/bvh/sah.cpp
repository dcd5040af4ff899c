// Top down: a node is cut in two where the surface area heuristic says, until its triangles fit
// into one pack, which is a leaf. The recursion is the driver's (builder/driver.h).
#include "labs/04_accel/bvh/sah.h"

#include "labs/04_accel/builder/driver.h"
#include "labs/04_accel/bvh/split.h"
#include "labs/04_accel/leaf/packs.h"

#include <algorithm>
#include <array>
#include <bit>
#include <memory>
#include <optional>
#include <utility>

namespace raylab::lab04 {
namespace {

// A cut through triangles is tried where the halves of the best cut between triangles overlap: half
// the surface of what both their boxes cover must be more than
constexpr double least_overlap = 1e-3;    // times that of the scene's box,
constexpr double least_own_overlap = 0.2; // and more than this times that of the node's box.
// In all, cuts add references until there are so many for each triangle.
constexpr double most_references = 1.4;
// Some boxes overlap however the triangles are parted, as those of needles do. So no cut through is
// tried below so many nodes, one right below the other, where it was tried and did not pay.
constexpr int most_in_vain = 3;

// What a node is built of.
struct Work {
    Items items;
    int depth;    // of the node
    double spare; // references that cuts through triangles may add
    int in_vain;  // nodes right above here, in a row, where a cut through triangles did not pay
};

// A node cut in two. Cuts through triangles make new items, and keep them here.
struct Halves {
    int axis;
    Work half[2];
    std::vector<BuildItem> made[2];
};

// Where to cut; the same for all threads.
struct Cutter {
    const std::vector<Triangle>& triangles;
    KdClip clip;
    double root_area;

    Halves cut(const Work& work) const {
        const Bounds centres = centres_of(work.items);
        // A tree of medians below may still need this many levels.
        const int halvings = std::bit_width(work.items.size());
        const bool deep = work.depth + halvings >= max_sah_depth;
        const Split split = deep ? Split{} : best_cut_between(work.items, centres);
        int in_vain = work.in_vain;
        if (split.overlap > least_overlap * root_area && work.spare >= 1 &&
            in_vain < most_in_vain) {
            Halves halves;
            if (cut_through(work, split, halves, in_vain)) return halves;
        }
        int axis = split.axis;
        std::size_t middle = axis >= 0 ? cut_between(work.items, centres, split) : 0;
        // There is no cut, or it leaves one side empty and would be made again and again.
        if (middle == 0 || middle == work.items.size())
            middle = cut_at_median(work.items, centres, axis);
        return halves_of(work, axis, work.items.subspan(0, middle), work.items.subspan(middle),
                         work.spare, in_vain);
    }

  private:
    // False if no cut through costs less than the one between, or if it leaves one side empty or
    // makes too many references. in_vain counts the tries; a cut that is made sets it to 0.
    bool cut_through(const Work& work, const Split& between, Halves& halves, int& in_vain) const {
        Bounds box;
        for (const BuildItem& item : work.items) box.include(item.box);
        if (between.overlap <= least_own_overlap * half_area(box)) return false;
        ++in_vain;
        const Split through = best_cut_through(work.items, box, triangles, between.cost);
        if (through.axis < 0) return false;
        std::vector<BuildItem> left, right;
        lab04::cut_through(work.items, triangles, clip, through, left, right);
        const std::size_t n = work.items.size();
        const double spare = work.spare - (double(left.size() + right.size()) - double(n));
        if (left.empty() || right.empty() || left.size() >= n || right.size() >= n || spare < 0)
            return false;
        halves = halves_of(work, through.axis, left, right, spare, 0);
        halves.made[0] = std::move(left), halves.made[1] = std::move(right);
        return true;
    }

    // The half with fewer triangles at the front, wherever they lie.
    static std::size_t cut_at_median(Items items, const Bounds& centres, int& axis) {
        const Vec3 extent = centres.high - centres.low;
        axis =
            extent.x >= extent.y ? (extent.x >= extent.z ? 0 : 2) : (extent.y >= extent.z ? 1 : 2);
        const std::size_t half = items.size() / 2;
        std::nth_element(items.begin(), items.begin() + half, items.end(),
                         [&](const BuildItem& a, const BuildItem& b) {
                             return a.centre(axis) < b.centre(axis) ||
                                    (a.centre(axis) == b.centre(axis) && a.index < b.index);
                         });
        return half;
    }

    // The references that may still be added are shared out by size, so that no subtree depends on
    // another.
    static Halves halves_of(const Work& work, int axis, Items left, Items right, double spare,
                            int in_vain) {
        const double share = spare / double(left.size() + right.size());
        return {axis,
                {{left, work.depth + 1, share * double(left.size()), in_vain},
                 {right, work.depth + 1, share * double(right.size()), in_vain}},
                {}};
    }
};

struct Child {
    int child; // as in BvhNode
    Bounds box;
};

int add_node(BvhTree& tree, int parent) {
    tree.nodes.push_back({{}, {no_child, no_child}, parent, 0});
    return static_cast<int>(tree.nodes.size()) - 1;
}

Child finish(BvhTree& tree, int self, int axis, const Child& left, const Child& right) {
    BvhNode& node = tree.nodes[self];
    node.axis = axis;
    set_child(node, 0, left.child, left.box);
    set_child(node, 1, right.child, right.box);
    Bounds box = left.box;
    box.include(right.box);
    return {self, box};
}

// Cuts nodes and writes them for the driver (builder/driver.h).
class SahBuilder {
  public:
    using Tree = BvhTree;
    using Part = Work;
    using Cut = Halves;
    using Root = Child;
    using Memory = std::shared_ptr<const std::vector<BuildItem>>;

    // memory: of the items that it begins with.
    SahBuilder(const Cutter& cutter, Memory memory) : cutter_(cutter), memory_(std::move(memory)) {}

    std::size_t size(const Work& work) const { return work.items.size(); }

    std::optional<Halves> cut(const Work& work) const {
        if (work.items.size() <= triangles_per_pack) return {};
        return cutter_.cut(work);
    }

    Child leaf(const Work& work, BvhTree& tree, int) const {
        tree.depth = std::max(tree.depth, work.depth);
        std::array<int, triangles_per_pack> indices;
        Bounds box;
        for (std::size_t i = 0; i < work.items.size(); ++i) {
            indices[i] = work.items[i].index;
            box.include(work.items[i].box);
        }
        append_packs(cutter_.triangles, {indices.data(), work.items.size()}, tree.packs);
        return {~static_cast<int>(tree.packs.size() - 1), box};
    }

    std::pair<SahBuilder, Work> take(Halves& cut, int k) const {
        auto& made = cut.made[k];
        const Memory memory =
            made.empty() ? memory_ : std::make_shared<std::vector<BuildItem>>(std::move(made));
        return {SahBuilder(cutter_, memory), cut.half[k]};
    }

    // The place of a node is its parent's number, and nodes come in a line.
    static int begin(BvhTree&) { return -1; }
    static int open(BvhTree& tree, int parent, const Halves&) { return add_node(tree, parent); }
    static int place_in(int node, int) { return node; }
    static Child close(BvhTree& tree, int node, const Halves& cut, const Child& left,
                       const Child& right) {
        return finish(tree, node, cut.axis, left, right);
    }

    static Child append(BvhTree& tree, int parent, const BvhTree& subtree, const Child& root) {
        const int nodes = static_cast<int>(tree.nodes.size()),
                  packs = static_cast<int>(tree.packs.size());
        const auto moved = [&](int child) { return child + (is_leaf(child) ? -packs : nodes); };
        for (BvhNode node : subtree.nodes) {
            for (int& child : node.child) child = moved(child);
            node.parent = node.parent < 0 ? parent : node.parent + nodes;
            tree.nodes.push_back(node);
        }
        tree.packs.insert(tree.packs.end(), subtree.packs.begin(), subtree.packs.end());
        tree.depth = std::max(tree.depth, subtree.depth);
        return {moved(root.child), root.box};
    }

  private:
    const Cutter& cutter_;
    Memory memory_;
};

} // namespace

BvhTree build_bvh_sah(const std::vector<Triangle>& triangles, int threads) {
    const auto items = std::make_shared<std::vector<BuildItem>>(build_items(triangles));
    if (items->empty()) return {};
    Bounds box;
    for (const BuildItem& item : *items) box.include(item.box);
    const float largest = max_component(glm::max(abs(box.low), abs(box.high)));
    const Cutter cutter{triangles, KdClip(largest), half_area(box)};
    const Work all{*items, 0, (most_references - 1) * double(items->size()), 0};

    BvhTree tree;
    const Child top = build_tree(SahBuilder(cutter, items), all, threads, tree);
    // A tree of one leaf: a root with nothing on its other side.
    if (is_leaf(top.child)) finish(tree, add_node(tree, -1), 0, top, {no_child, {}});
    return tree;
}

} // namespace raylab::lab04
