// Building a KD-tree, from the root down; see kd/build.h. The recursion is the driver's
// (builder/driver.h); here cells are cut and nodes written.
#include "labs/04_accel/kd/build.h"

#include "common/geometry/triangle.h"
#include "common/task/not_implemented.h"
#include "labs/04_accel/builder/driver.h"
#include "labs/04_accel/leaf/packs.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

namespace raylab::lab04 {

namespace {

// False: intersect() never hits this triangle, since a corner is not finite or its plane has no
// normal.
bool can_be_hit(const Triangle& triangle) {
    for (const Vec3& v : triangle.v)
        if (!is_finite(v)) return false;
    const DVec3 normal = exact_plane(triangle).normal;
    return normal.x != 0 || normal.y != 0 || normal.z != 0;
}

// What a cell is built of, apart from its triangles.
struct Cell {
    Bounds box;
    int depth;     // so many more cuts may lie one below the other
    double copies; // references that cuts below here may add
};

struct Halves {
    KdPlane plane;
    Cell half[2]; // below the plane, above it
};

// A cell, and where its references are: on top of the stack work_, from `begin` on. The references
// of an upper half lie on the stack later_, from `waiting` on, while the lower half is built.
struct Part {
    Cell cell;
    std::size_t begin;
    std::size_t waiting = nowhere;

    static constexpr std::size_t nowhere = -1;
};

struct Cut {
    KdPlane plane;
    Part half[2];
};

// Cuts cells and writes nodes for the driver (builder/driver.h). One for each piece of the tree:
// the stacks are its own.
class KdBuilder {
  public:
    using Tree = KdTree;
    using Part = lab04::Part;
    using Cut = lab04::Cut;
    struct Root {}; // nothing: a node knows its children by their place

    KdBuilder(const std::vector<Triangle>& triangles, const KdBuildSettings& settings, KdClip clip,
              std::vector<KdReference> references)
        : triangles_(triangles), settings_(settings), clip_(clip), work_(std::move(references)) {}

    std::size_t size(const Part& part) const { return work_.size() - part.begin; }

    std::optional<Cut> cut(const Part& part) {
        if (part.waiting != Part::nowhere) { // its turn has come
            work_.insert(work_.end(), later_.begin() + part.waiting, later_.end());
            later_.resize(part.waiting);
        }
        const std::size_t waiting = later_.size();
        const std::optional<Halves> halves = cut(part.cell, part.begin);
        if (!halves) return {};
        return Cut{halves->plane,
                   {{halves->half[0], part.begin}, {halves->half[1], part.begin, waiting}}};
    }

    // Takes the references off work_.
    Root leaf(const Part& part, KdTree& tree, int place) {
        std::vector<int> indices;
        for (std::size_t i = part.begin; i < work_.size(); ++i)
            indices.push_back(work_[i].triangle);
        work_.resize(part.begin);
        const int first = int(tree.packs.size());
        append_packs(triangles_, indices, tree.packs);
        tree.nodes[place] = KdNode::leaf(first, int(tree.packs.size()) - first);
        return {};
    }

    // Of the first cut of a piece: what is below is all of work_, what is above all of later_.
    std::pair<KdBuilder, Part> take(const Cut& cut, int k) {
        return {KdBuilder(triangles_, settings_, clip_, std::move(k == 0 ? work_ : later_)),
                Part{cut.half[k].cell, 0}};
    }

    static int begin(KdTree& tree) {
        tree.nodes.emplace_back();
        return 0;
    }
    // Two children lie side by side, behind all nodes so far; the first one's place is returned.
    static int open(KdTree& tree, int place, const Cut& cut) {
        const int children = int(tree.nodes.size());
        tree.nodes[place] = KdNode::inner(cut.plane.axis, cut.plane.at, children);
        tree.nodes.resize(children + 2);
        return children;
    }
    static int place_in(int children, int k) { return children + k; }
    static Root close(KdTree&, int, const Cut&, Root, Root) { return {}; }

    static Root append(KdTree& tree, int place, const KdTree& subtree, Root) {
        const int nodes = int(tree.nodes.size()), packs = int(tree.packs.size());
        const auto moved = [&](const KdNode& from) { // the root, node 0, does not lie with the rest
            return from.is_leaf()
                       ? KdNode::leaf(from.first_pack + packs, from.packs())
                       : KdNode::inner(from.axis(), from.split, from.below() + nodes - 1);
        };
        tree.nodes[place] = moved(subtree.nodes[0]);
        std::transform(subtree.nodes.begin() + 1, subtree.nodes.end(),
                       std::back_inserter(tree.nodes), moved);
        tree.packs.insert(tree.packs.end(), subtree.packs.begin(), subtree.packs.end());
        return {};
    }

  private:
    // Cuts the cell where that costs least, if a leaf costs more and the limits allow it. The
    // references below the plane stay on work_, those above it go to later_.
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

    // How many references the plane cuts in two.
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
    std::vector<KdReference> work_,
        later_; // stacks: of the cell at hand, of upper halves that wait
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
    build_tree(KdBuilder(triangles, settings, clip, std::move(references)), Part{cell, 0},
               settings.threads, tree);
    return tree;
}

} // namespace raylab::lab04
