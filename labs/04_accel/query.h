// What a walk is for: the closest hit, or any. A walk brings a query the leaves that the ray comes
// to; the query tests their triangles, and says how far the walk still has to look.
//
// Walks are templates over the query, so there is one of each kind, not two.
#pragma once

#include "common/geometry/bounds.h"
#include "common/geometry/intersect.h"
#include "common/scene/view.h"
#include "labs/04_accel/bvh.h"
#include "labs/04_accel/triangle_block.h"

namespace raylab::lab04 {

// The triangles as leaves hold them, and as the scene does.
struct Leaves {
    Array<TriangleBlock> blocks;
    Array<Triangle> triangles;
};

// Of one ray: the ledger's nodes and triangles a ray. A node is what is read at once: a pair of
// boxes, eight boxes, a split plane.
struct WalkCounts {
    std::uint32_t nodes = 0;
    std::uint32_t blocks = 0;
};

// No walk visits this many nodes. A student's endless one ends here, with a message.
constexpr std::uint32_t most_steps = 1u << 22;

class Query {
  public:
    HD Query(const Leaves& leaves, const Ray& ray)
        : slab(ray), leaves_(leaves), sheared_(ray), glance_(sheared_) {}

    const SlabRay slab; // the ray, for box tests

    HD const Ray& ray() const { return sheared_.ray; }
    HD const WalkCounts& counts() const { return counts_; }
    HD bool endless() const { return counts_.nodes >= most_steps; }

    // Counts a node. False: this walk has no end, and must return.
    HD bool step() { return ++counts_.nodes < most_steps; }

  protected:
    // Calls met(triangle, index, t) for each triangle of the block that the ray meets in (0,
    // reach], until it returns true.
    template <class Met> HD_HOT bool test(int block, float reach, const Met& met) {
        ++counts_.blocks;
        const TriangleBlock& four = leaves_.blocks[block];
        for (std::uint32_t left = glance(four, sheared_, glance_, reach); left != 0;
             left &= left - 1) {
            const int index = four.index[lowest_bit(left)];
            const Triangle& triangle = leaves_.triangles[index];
            float t;
            if (intersect(triangle, sheared_, t) && met(triangle, index, t)) return true;
        }
        return false;
    }

  private:
    const Leaves& leaves_;
    ShearedRay sheared_;
    GlanceRay glance_;
    WalkCounts counts_;
};

// The closest hit in (0, ray.t_max); of two at the same t that with the lowest id, so that no
// structure, and no order of a walk, changes an image.
class ClosestHit : public Query {
  public:
    using Query::Query;

    HD const Hit& hit() const { return hit_; }

    // Nothing beyond this t matters. At it, a lower id does: walks skip a box only if it begins
    // behind it.
    HD float reach() const { return glm::min(hit_.t, ray().t_max); }

    // Tests a block of triangles. True: the walk may end.
    HD_HOT bool visit(int block) {
        return test(block, reach(), [&](const Triangle& triangle, int index, float t) {
            if (hit_.is_beaten_by(t, triangle.tags.id))
                hit_ = {t, triangle.tags.id, Shape::triangle, index};
            return false;
        });
    }

  private:
    Hit hit_;
};

// Whether anything is in (0, ray.t_max): the first hit found ends the walk.
class AnyHit : public Query {
  public:
    using Query::Query;

    HD bool found() const { return found_; }
    HD float reach() const { return ray().t_max; }

    HD_HOT bool visit(int block) {
        found_ = test(block, reach(), [](const Triangle&, int, float) { return true; });
        return found_;
    }

  private:
    bool found_ = false;
};

} // namespace raylab::lab04
