// What a walk looks for: the closest hit, or any hit. The walk calls the query with each leaf that
// the ray comes to. The query tests what is in the leaf, here triangles, and says how far the walk
// still has to look.
//
// Walks are templates over the query. So each walk is written once, for both.
#pragma once

#include "common/geometry/bounds.h"
#include "common/scene/view.h"
#include "common/trace/intersect.h"
#include "labs/04_accel/bvh/bvh.h"
#include "labs/04_accel/leaf/fetch_ahead.h"
#include "labs/04_accel/leaf/triangle_pack.h"

namespace raylab::lab04 {

// The triangles as leaves hold them, and as the scene does.
struct Leaves {
    Array<TrianglePack> packs;
    Array<Triangle> triangles;
};

// Of one ray: the ledger's nodes and packs a ray. A node is what is read at once: a pair of boxes,
// eight boxes, a split plane.
struct WalkCounts {
    std::uint32_t nodes = 0;
    std::uint32_t packs = 0;
};

// No sound walk visits so many nodes. A walk without an end is stopped here, with a message.
constexpr std::uint32_t most_steps = 1u << 22;

// What every query has, whatever is in the leaves.
class Query {
  public:
    HD_HOT explicit Query(const Ray& ray) : slab(ray), ray_(ray) {}

    const SlabRay slab; // the ray, for box tests

    HD const Ray& ray() const { return ray_; }
    HD const WalkCounts& counts() const { return counts_; }
    HD bool endless() const { return counts_.nodes >= most_steps; }

    // Counts a node. False: this walk has no end, and must return.
    HD bool step() { return ++counts_.nodes < most_steps; }

  protected:
    HD void count_pack() { ++counts_.packs; }

  private:
    Ray ray_;
    WalkCounts counts_;
};

class TriangleQuery : public Query {
  public:
    HD_HOT TriangleQuery(const Leaves& leaves, const Ray& ray)
        : Query(ray), leaves_(leaves), glance_(ray, slab.inv_d) {}

    HD int packs() const { return leaves_.packs.size; } // all there are

    // Loads a pack that may be visited soon.
    HD_HOT void ask_for(int pack) const { fetch_ahead(leaves_.packs.data + pack); }

  protected:
    HD_HOT TriangleGlance look_at(int pack, float reach) {
        count_pack();
        return glance(leaves_.packs[pack], glance_, reach);
    }
    HD bool meets(int pack, int lane, float& t) const {
        return intersect(corners_in(leaves_.packs[pack], lane), ShearedRay(ray()), t);
    }
    // Of a triangle that the ray passes inside of: only t is left to find.
    HD bool meets_inside(int pack, int lane, float& t) const {
        return intersect(exact_plane(corners_in(leaves_.packs[pack], lane)), ray(), t);
    }
    HD int index_of(int pack, int lane) const { return leaves_.packs[pack].index[lane]; }
    HD int id_of(int index) const { return leaves_.triangles[index].tags.id; }

    // Does the glance alone prove that the lane's triangle is hit?
    HD_HOT bool is_hit(const TriangleGlance& seen, int lane) const {
        return seen.sure >> lane & 1 && seen.begin[lane] > 0 && seen.end[lane] < ray().t_max;
    }

  private:
    const Leaves& leaves_;
    GlanceRay glance_;
};

// The closest hit in (0, ray.t_max); of two at the same t that with the lowest id, so that no
// structure, and no order of a walk, changes an image.
//
// Most rays pass well inside the triangle that they hit, and hit nothing else at almost the same t.
// Then the glance's intervals of t lie apart and tell which triangle is the closest. The exact t is
// computed once, when the walk is over.
class ClosestHit : public TriangleQuery {
  public:
    HD_HOT ClosestHit(const Leaves& leaves, const Ray& ray)
        : TriangleQuery(leaves, ray), reach_(ray.t_max) {}

    // A box that was crossed once may lie out of reach later.
    static constexpr bool reach_shrinks = true;

    // Of two children that lie apart along this axis, which one does the walk visit first: 0, the
    // lower one, or 1? Here it is the nearer one, as an early hit shortens the ray.
    HD int first(int axis) const { return slab.negative[axis]; }

    // Call it when the walk is over.
    HD const Hit& hit() {
        settle();
        return hit_;
    }

    // Nothing beyond this t matters. A triangle at this very t wins if its id is lower, so walks
    // skip a box only if it begins beyond.
    HD float reach() const { return reach_; }

    // Tests a pack of triangles. True: the walk may end.
    HD_HOT bool visit(int pack) {
        const TriangleGlance seen = look_at(pack, reach_);
        for (std::uint32_t left = seen.maybe; left != 0; left &= left - 1) {
            const int lane = lowest_bit(left);
            if (seen.begin[lane] > reach_) continue;
            if (is_hit(seen, lane) && seen.end[lane] < begin_) {
                pack_ = pack, lane_ = lane;
                begin_ = seen.begin[lane], reach_ = seen.end[lane];
                continue;
            }
            settle();
            float t;
            if (meets(pack, lane, t)) found(index_of(pack, lane), t);
        }
        return false;
    }

  private:
    // Computes the exact t of the hit that a glance has found.
    HD void settle() {
        if (lane_ < 0) return;
        float t;
        if (meets_inside(pack_, lane_, t)) {
            hit_ = {};
            found(index_of(pack_, lane_), t);
        }
        lane_ = -1;
    }
    HD void found(int index, float t) {
        const int id = id_of(index);
        if (hit_.is_beaten_by(t, id)) hit_ = {t, id, Shape::triangle, index};
        begin_ = reach_ = glm::min(hit_.t, ray().t_max);
    }

    Hit hit_;              // the closest exact hit; while lane_ >= 0 there is a closer one:
    int pack_, lane_ = -1; // a glance has found it, in this lane of this pack
    float begin_ = infinity, reach_; // t of the closest hit lies between these
};

// Whether anything is in (0, ray.t_max): the first hit found ends the walk.
class AnyHit : public TriangleQuery {
  public:
    using TriangleQuery::TriangleQuery;

    static constexpr bool reach_shrinks = false;

    // Here it is the farther one. Near its origin a shadow ray mostly crosses boxes of the surface
    // that it leaves and misses what is in them. What blocks it, a wall perhaps, lies farther away.
    HD int first(int axis) const { return !slab.negative[axis]; }

    HD bool found() const { return found_; }
    HD float reach() const { return ray().t_max; }

    HD_HOT bool visit(int pack) {
        const TriangleGlance seen = look_at(pack, reach());
        for (std::uint32_t left = seen.maybe; left != 0 && !found_; left &= left - 1) {
            const int lane = lowest_bit(left);
            float t;
            found_ = is_hit(seen, lane) || meets(pack, lane, t);
        }
        return found_;
    }

  private:
    bool found_ = false;
};

} // namespace raylab::lab04
