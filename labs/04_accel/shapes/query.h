// The queries of the walk through the tree over spheres and quads. They are as those in
// leaf/query.h, but a leaf is a group of sixteen shapes.
//
// This walk comes after the triangles' walk and begins with the hit that was found there. Of two
// hits at the same t the lower id wins, so it does not matter which walk comes first.
#pragma once

#include "common/trace/intersect.h"
#include "labs/04_accel/leaf/query.h"
#include "labs/04_accel/shapes/tree.h"

namespace raylab::lab04 {

class ShapeQuery : public Query {
  public:
    HD_HOT ShapeQuery(const SceneView& scene, const ShapeTreeView& tree, const Ray& ray)
        : Query(ray), scene_(scene), tree_(tree) {}

  protected:
    // Calls meet(shape, index, id, t) for each hit in a leaf, until it returns false.
    template <class Meet, class Reach>
    HD_HOT void look_at(int leaf, const Meet& meet, const Reach& reach) {
        count_pack();
        const int spheres = tree_.sphere_groups.size;
        if (leaf < spheres)
            for_each_hit_in(tree_.sphere_groups[leaf], scene_.spheres, ray(), meet, reach);
        else
            for_each_hit_in(tree_.quad_groups[leaf - spheres], scene_.quads, ray(), meet, reach);
    }

  private:
    const SceneView& scene_;
    const ShapeTreeView& tree_;
};

// The closest of `hit` and the shapes in the tree.
class ClosestShape : public ShapeQuery {
  public:
    HD_HOT ClosestShape(const SceneView& scene, const ShapeTreeView& tree, const Ray& ray,
                        const Hit& hit)
        : ShapeQuery(scene, tree, ray), hit_(hit) {}

    static constexpr bool reach_shrinks = true;
    HD int first(int axis) const { return slab.negative[axis]; } // the nearer one
    HD float reach() const { return glm::min(hit_.t, ray().t_max); }
    HD const Hit& hit() const { return hit_; }

    HD_HOT bool visit(int leaf) {
        look_at(
            leaf,
            [this](Shape shape, int index, int id, float t) {
                if (hit_.is_beaten_by(t, id)) hit_ = {t, id, shape, index};
                return true;
            },
            [this] { return reach(); });
        return false;
    }

  private:
    Hit hit_;
};

// Whether any of them is in (0, ray.t_max).
class AnyShape : public ShapeQuery {
  public:
    using ShapeQuery::ShapeQuery;

    static constexpr bool reach_shrinks = false;
    HD int first(int axis) const { return !slab.negative[axis]; } // the farther one
    HD float reach() const { return ray().t_max; }
    HD bool found() const { return found_; }

    HD_HOT bool visit(int leaf) {
        look_at(
            leaf, [this](Shape, int, int, float) { return !(found_ = true); },
            [this] { return reach(); });
        return found_;
    }

  private:
    bool found_ = false;
};

} // namespace raylab::lab04
