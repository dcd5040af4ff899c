// Building a KD-tree, from the root down; see kd/build.h. Subtrees are built by tasks
// (build/tasks.h).
#include "labs/04_accel/kd/build.h"

#include "common/geometry/triangle.h"
#include "common/task/not_implemented.h"
#include "labs/04_accel/build/tasks.h"
#include "labs/04_accel/leaf/packs.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <optional>

namespace raylab::lab04 {

namespace {

// What intersect() never hits, whatever the ray: its plane has no normal, or no place.
bool can_be_hit(const Triangle& triangle) {
    for (const Vec3& v : triangle.v)
        if (!is_finite(v)) return false;
    const DVec3 normal = exact_plane(triangle).normal;
    return normal.x != 0 || normal.y != 0 || normal.z != 0;
}

// What a cell is built of, apart from its triangles.
struct Cell {
    Bounds box;
    int depth;     // cuts that are left on this path
    double copies; // references that the cell may still add
};

struct Halves {
    KdPlane plane;
    Cell half[2]; // below the plane, above it
};

// Cuts cells, and makes subtrees of them, numbered from 0. One for each thread: its stacks are its
// own.
class Builder {
  public:
    Builder(const std::vector<Triangle>& triangles, const KdBuildSettings& settings, KdClip clip)
        : triangles_(triangles), settings_(settings), clip_(clip) {}

    KdTree build(const Cell& cell, std::vector<KdReference> references) {
        work_ = std::move(references);
        tree_.nodes.emplace_back();
        subdivide(0, cell, 0);
        return std::move(tree_);
    }

    // The two parts of a cell, and their references; nothing if it is better left whole.
    std::optional<Halves> cut(const Cell& cell, std::vector<KdReference> references,
                              std::vector<KdReference>& below, std::vector<KdReference>& above) {
        work_ = std::move(references);
        const auto halves = cut(cell, 0);
        below = std::move(work_), above = std::move(later_);
        return halves;
    }

  private:
    // Takes the references off work_ and puts a leaf in place of the node.
    void make_leaf(int node, std::size_t begin) {
        std::vector<int> indices;
        for (std::size_t i = begin; i < work_.size(); ++i) indices.push_back(work_[i].triangle);
        work_.resize(begin);
        const int first = int(tree_.packs.size());
        append_packs(triangles_, indices, tree_.packs);
        tree_.nodes[node] = KdNode::leaf(first, int(tree_.packs.size()) - first);
    }

    // Makes the node a leaf, or cuts its cell and goes on with the parts; either takes the cell's
    // references, work_[begin], ... to the end, off work_. Of two children the lower is finished
    // first, while the references of the upper wait on later_.
    void subdivide(int node, const Cell& cell, std::size_t begin) {
        const std::size_t later_begin = later_.size();
        const auto halves = cut(cell, begin);
        if (!halves) return make_leaf(node, begin);
        const int children = int(tree_.nodes.size());
        tree_.nodes[node] = KdNode::inner(halves->plane.axis, halves->plane.at, children);
        tree_.nodes.resize(children + 2);
        subdivide(children, halves->half[0], begin);
        work_.insert(work_.end(), later_.begin() + later_begin, later_.end());
        later_.resize(later_begin);
        subdivide(children + 1, halves->half[1], begin);
    }

    // Cuts the cell where that costs least, if a leaf costs more and the limits allow it: what is
    // below stays on work_, and what is above goes to later_.
    // Steps:
    // 1. Find the best plane, unless one pack holds all or no cut is left on this path.
    // 2. Return nothing if a leaf costs no more, or if the cut adds more copies than are left.
    // 3. Part the references. One that reaches across the plane is clipped into two (clip_.cut());
    //    an empty part is dropped.
    // 4. What the cut added is taken off the copies; the rest is shared out by the halves' sizes.
    // 5. Each half gets its part of the box, and one cut less.
    //[ task 4.1
    std::optional<Halves> cut(const Cell& cell, std::size_t begin) {
        const std::span<const KdReference> here(work_.data() + begin, work_.size() - begin);
        const int n = int(here.size());
        KdPlane plane;
        if (packs_for(n) > 1 && cell.depth > 0) plane = best_plane(here, cell.box, settings_.costs);
        if (plane.cost >= packs_for(n) || copies(here, plane) > cell.copies) return {};

        const std::size_t later_begin = later_.size();
        const int below = part(begin, plane), above = int(later_.size() - later_begin);
        const double left = cell.copies - (below + above - n);
        const double lower_copies = left * below / std::max(below + above, 1);
        Bounds low = cell.box, high = cell.box;
        low.high[plane.axis] = high.low[plane.axis] = plane.at;
        return Halves{
            plane,
            {{low, cell.depth - 1, lower_copies}, {high, cell.depth - 1, left - lower_copies}}};
    }

    // References that a cut makes two of.
    static int copies(std::span<const KdReference> references, const KdPlane& plane) {
        return int(std::count_if(references.begin(), references.end(), [&](const auto& reference) {
            return reference.box.low[plane.axis] < plane.at &&
                   reference.box.high[plane.axis] > plane.at;
        }));
    }

    // Leaves the references below the plane on work_, and puts those above it on later_. Returns
    // how many are below.
    int part(std::size_t begin, const KdPlane& plane) {
        std::size_t kept = begin;
        for (std::size_t i = begin; i < work_.size(); ++i) {
            const KdReference reference = work_[i];
            const float low = reference.box.low[plane.axis], high = reference.box.high[plane.axis];
            if (high <= plane.at) {
                work_[kept++] = reference;
            } else if (low >= plane.at) {
                later_.push_back(reference);
            } else {
                Bounds below, above;
                clip_.cut(triangles_[reference.triangle], reference.box, plane.axis, plane.at,
                          below, above);
                if (!is_empty(above)) later_.push_back({above, reference.triangle});
                if (!is_empty(below)) work_[kept++] = {below, reference.triangle};
            }
        }
        work_.resize(kept);
        return int(kept - begin);
    }
    //| // One leaf for all: right, and brute force.
    //| std::optional<Halves> cut(const Cell&, std::size_t) {
    //|     not_implemented("4.1", "build_kd_tree()");
    //|     return {};
    //| }
    //]

    const std::vector<Triangle>& triangles_;
    KdBuildSettings settings_;
    KdClip clip_;
    std::vector<KdReference> work_, later_; // stacks: of this cell, of cells that wait
    KdTree tree_;
};

// A cell at the top of the tree that is cut, or a subtree that is built in one go.
struct Piece {
    const Builder& builder; // what theirs are copied from
    Cell cell;
    std::vector<KdReference> references;
    KdPlane plane = {};
    std::unique_ptr<Piece> half[2] = {};
    KdTree tree = {}; // if it is whole

    std::size_t size() const { return references.size(); }

    bool cut() {
        std::vector<KdReference> below, above;
        const auto halves = Builder(builder).cut(cell, std::move(references), below, above);
        if (!halves) {
            references = std::move(below);
            return false;
        }
        plane = halves->plane;
        half[0].reset(new Piece{builder, halves->half[0], std::move(below)});
        half[1].reset(new Piece{builder, halves->half[1], std::move(above)});
        return true;
    }

    void build() { tree = Builder(builder).build(cell, std::move(references)); }

    // Puts it in place of a node, in the order in which one thread makes nodes.
    void append_to(KdTree& all, int node) {
        const int nodes = int(all.nodes.size()), packs = int(all.packs.size());
        if (half[0]) {
            all.nodes[node] = KdNode::inner(plane.axis, plane.at, nodes);
            all.nodes.resize(nodes + 2);
            half[0]->append_to(all, nodes);
            return half[1]->append_to(all, nodes + 1);
        }
        const auto moved = [&](const KdNode& from) { // the root, node 0, does not lie with the rest
            return from.is_leaf()
                       ? KdNode::leaf(from.first_pack + packs, from.packs())
                       : KdNode::inner(from.axis(), from.split, from.below() + nodes - 1);
        };
        all.nodes[node] = moved(tree.nodes[0]);
        std::transform(tree.nodes.begin() + 1, tree.nodes.end(), std::back_inserter(all.nodes),
                       moved);
        all.packs.insert(all.packs.end(), tree.packs.begin(), tree.packs.end());
    }
};

} // namespace

int kd_depth_limit(std::size_t triangles) {
    return std::min(kd_max_depth,
                    int(8 + 1.3 * std::log2(double(std::max<std::size_t>(triangles, 1)))));
}

KdTree build_kd_tree(const std::vector<Triangle>& triangles, const KdBuildSettings& settings) {
    std::vector<int> good;
    float largest = 0;
    for (int i = 0; i < int(triangles.size()); ++i) {
        if (!can_be_hit(triangles[i])) continue;
        good.push_back(i);
        for (const Vec3& v : triangles[i].v) largest = std::max(largest, max_component(abs(v)));
    }
    KdTree tree;
    if (good.empty()) return tree;
    const KdClip clip(largest);
    std::vector<KdReference> references;
    for (const int i : good) {
        references.push_back({clip.whole(triangles[i]), i});
        tree.bounds.include(references.back().box);
    }
    const Cell cell{tree.bounds, kd_depth_limit(good.size()),
                    (settings.copies - 1) * double(good.size())};
    const Builder builder(triangles, settings, clip);
    Piece root{builder, cell, std::move(references)};
    build_in_pieces(root, settings.threads);
    tree.nodes.emplace_back();
    root.append_to(tree, 0);
    return tree;
}

} // namespace raylab::lab04
