// Building a KD-tree, from the root down; see kd_build.h.
#include "labs/04_accel/kd_build.h"

#include "common/geometry/triangle.h"
#include "common/task/not_implemented.h"
#include "labs/04_accel/leaf_blocks.h"

#include <algorithm>
#include <cmath>

namespace raylab::lab04 {

namespace {

// What intersect() never hits, whatever the ray: its plane has no normal, or no place.
bool can_be_hit(const Triangle& triangle) {
    for (const Vec3& v : triangle.v)
        if (!is_finite(v)) return false;
    const DVec3 normal = exact_plane(triangle).normal;
    return normal.x != 0 || normal.y != 0 || normal.z != 0;
}

class Builder {
  public:
    Builder(const std::vector<Triangle>& triangles, const KdBuildSettings& settings)
        : triangles_(triangles), settings_(settings), clip_(largest_coordinate()) {}

    KdTree build() {
        for (int i = 0; i < int(triangles_.size()); ++i) {
            if (!can_be_hit(triangles_[i])) continue;
            work_.push_back({clip_.whole(triangles_[i]), i});
            tree_.bounds.include(work_.back().box);
        }
        if (work_.empty()) return std::move(tree_);
        tree_.nodes.emplace_back();
        subdivide(0, tree_.bounds,
                  {0, kd_depth_limit(work_.size()), (settings_.copies - 1) * work_.size()});
        return std::move(tree_);
    }

  private:
    struct Limits {
        std::size_t begin; // the cell's references are work_[begin], ... to the end
        int depth;         // cuts that are left on this path
        double copies;     // references that this subtree may add
    };

    float largest_coordinate() const {
        float largest = 0;
        for (const Triangle& triangle : triangles_)
            if (can_be_hit(triangle))
                for (const Vec3& v : triangle.v) largest = std::max(largest, max_component(abs(v)));
        return largest;
    }

    // Takes the references off work_ and puts a leaf in place of the node.
    void make_leaf(int node, std::size_t begin) {
        std::vector<int> indices;
        for (std::size_t i = begin; i < work_.size(); ++i) indices.push_back(work_[i].triangle);
        work_.resize(begin);
        const int first = int(tree_.blocks.size());
        append_blocks(triangles_, indices, tree_.blocks);
        tree_.nodes[node] = KdNode::leaf(first, int(tree_.blocks.size()) - first);
    }

    // Makes the node a leaf, or cuts its cell and goes on with the parts; either takes the cell's
    // references off work_. Of two children the lower is finished first, while the references of
    // the upper wait on later_.
    //[ task 4.1
    void subdivide(int node, const Bounds& cell, Limits limits) {
        const std::span<const KdReference> here(work_.data() + limits.begin,
                                                work_.size() - limits.begin);
        const int n = int(here.size());
        KdPlane plane;
        if (blocks_for(n) > 1 && limits.depth > 0) plane = best_plane(here, cell, settings_.costs);
        if (plane.cost >= blocks_for(n) || copies(here, plane) > limits.copies) {
            make_leaf(node, limits.begin);
            return;
        }
        const std::size_t later_begin = later_.size();
        const int below = part(limits.begin, plane), above = int(later_.size() - later_begin);
        limits.copies -= below + above - n;
        const int children = int(tree_.nodes.size());
        tree_.nodes[node] = KdNode::inner(plane.axis, plane.at, children);
        tree_.nodes.resize(children + 2);
        --limits.depth;

        Bounds low = cell, high = cell;
        low.high[plane.axis] = high.low[plane.axis] = plane.at;
        Limits lower = limits, upper = limits;
        lower.copies = limits.copies * below / std::max(below + above, 1);
        upper.copies = limits.copies - lower.copies;
        subdivide(children, low, lower);
        work_.insert(work_.end(), later_.begin() + later_begin, later_.end());
        later_.resize(later_begin);
        subdivide(children + 1, high, upper);
    }

    // References that a cut makes two of.
    static int copies(std::span<const KdReference> references, const KdPlane& plane) {
        return int(std::count_if(references.begin(), references.end(), [&](const auto& reference) {
            return (&reference.box.low.x)[plane.axis] < plane.at &&
                   (&reference.box.high.x)[plane.axis] > plane.at;
        }));
    }

    // Leaves the references below the plane on work_, and puts those above it on later_. Returns
    // how many are below.
    int part(std::size_t begin, const KdPlane& plane) {
        std::size_t kept = begin;
        for (std::size_t i = begin; i < work_.size(); ++i) {
            const KdReference reference = work_[i];
            const float low = (&reference.box.low.x)[plane.axis],
                        high = (&reference.box.high.x)[plane.axis];
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
    //| void subdivide(int node, const Bounds&, Limits limits) {
    //|     not_implemented("4.1", "build_kd_tree()");
    //|     make_leaf(node, limits.begin);
    //| }
    //]

    const std::vector<Triangle>& triangles_;
    KdBuildSettings settings_;
    KdClip clip_;
    std::vector<KdReference> work_, later_; // stacks: of this cell, of cells that wait
    KdTree tree_;
};

} // namespace

int kd_depth_limit(std::size_t triangles) {
    return std::min(kd_max_depth,
                    int(8 + 1.3 * std::log2(double(std::max<std::size_t>(triangles, 1)))));
}

KdTree build_kd_tree(const std::vector<Triangle>& triangles, const KdBuildSettings& settings) {
    return Builder(triangles, settings).build();
}

} // namespace raylab::lab04
