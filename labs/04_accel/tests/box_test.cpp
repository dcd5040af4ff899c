// What the walks through boxes rely on: no box that a ray meets is missed. And what they promise:
// each comes to the leaves that its twin with a stack comes to, by few nodes.
#include "common/geometry/tests/support.h"
#include "labs/04_accel/tests/box_cases.h"

#include <algorithm>

namespace raylab::lab04 {

namespace {

using test::Real;

// At a corner, an edge, a face or the inside of the box, or along the axes past them.
Ray ray_at(const Bounds& box, Dice& dice) {
    const auto place_in = [&] {
        Vec3 p;
        for (int axis = 0; axis < 3; ++axis) {
            const float places[] = {box.low[axis], box.high[axis],
                                    dice.between(box.low[axis], box.high[axis])};
            p[axis] = places[dice.below(3)];
        }
        return p;
    };
    const Vec3 target = place_in(), extent = box.high - box.low;
    const float size = max_component(extent) > 0 ? max_component(extent) : 1.0f;
    const float away = size * power_of_two(dice, -10, 20);
    Vec3 o = dice.below(4) > 0 ? target + away * dice.direction() : place_in();
    for (int axis = 0; axis < 3; ++axis)
        if (dice.below(6) == 0) o[axis] = target[axis];
    Vec3 d = target - o;
    if (!(dot(d, d) > 0)) d = dice.direction();
    for (int axis = 0; axis < 3; ++axis) {
        const int way = dice.below(12);
        if (way == 0) d[axis] = std::copysign(0.0f, d[axis]);
        if (way == 1) d[axis] = -0.0f;
        if (way == 2) d[axis] *= power_of_two(dice, -120, -30);
    }
    if (!(dot(d, d) > 0)) d = dice.direction();
    d = normalize(d);
    return {o, d, dice.below(2) ? infinity : length(target - o) * dice.between(0.5f, 1.5f)};
}

// Does the ray cross the box within [0, t_max], closed, by arithmetic with 64 bits?
bool crosses_exactly(const Bounds& box, const Ray& ray) {
    Real begin = 0, end = ray.t_max;
    for (int axis = 0; axis < 3; ++axis) {
        const Real low = Real(box.low[axis]) - ray.o[axis],
                   high = Real(box.high[axis]) - ray.o[axis];
        const Real d = ray.d[axis];
        if (d == 0) {
            if (low > 0 || high < 0) return false;
            continue;
        }
        begin = std::max(begin, std::min(low / d, high / d));
        end = std::min(end, std::max(low / d, high / d));
    }
    return begin <= end;
}

// Is the ray, all the time, not between the two faces across an axis?
bool passes_beside(const WideNode& node, int slot, const Ray& ray) {
    for (int axis = 0; axis < 3; ++axis) {
        const double origin = node.origin[axis], step = node.step, o = ray.o[axis];
        if (ray.d[axis] == 0 && (o < origin + step * grid_face(node, slot, axis, 0) ||
                                 o > origin + step * grid_face(node, slot, axis, 1)))
            return true;
    }
    return false;
}

TEST(Boxes, NoBoxIsMissedThatARayMeets) {
    Dice dice(34);
    int met = 0, missed[3] = {}, beside = 0;
    for (int i = 0; i < test::rays(20000, 1000000); ++i) {
        const BoxTree made = any_boxes(2 + dice.below(7), dice);
        const WideTree wide = build_wide(made.tree);
        for (int k = 0; k < 16; ++k) {
            const Ray ray = ray_at(made.boxes[dice.below(int(made.boxes.size()))], dice);
            const SlabRay slab(ray);
            const std::uint32_t slots =
                crossed(wide.nodes[0], WideRay(ray, slab.inv_d, wide.extent), ray.t_max);
            for_each_slot(wide, 0, [&](int node, int slot, int leaf) {
                if (node != 0 || !crosses_exactly(made.boxes[leaf], ray)) return;
                ++met;
                missed[0] += !(slots >> slot & 1);
                missed[1] += !crosses(made.boxes[leaf], slab, ray.t_max);
            });
            for (int slot = 0; slot < wide_children; ++slot)
                beside += slots >> slot & 1 && passes_beside(wide.nodes[0], slot, ray);
            for (const BvhNode& node : made.tree.nodes) {
                const PairCrossing pair = cross(node, slab, ray.t_max);
                missed[2] += crosses_exactly(child_box(node, 0), ray) && !pair.met0;
                missed[2] += crosses_exactly(child_box(node, 1), ray) && !pair.met1;
            }
        }
    }
    EXPECT_GT(met, 100000);
    EXPECT_EQ(missed[0], 0) << "eight boxes on a grid";
    EXPECT_EQ(missed[1], 0) << "one box";
    EXPECT_EQ(missed[2], 0) << "a pair of boxes";
    EXPECT_EQ(beside, 0) << "a ray across an axis enters boxes that it is not between";
}

// Remembers the leaves it is brought.
struct Recorder : ClosestHit {
    using ClosestHit::ClosestHit;
    bool visit(int pack) {
        visited.push_back(pack);
        return ClosestHit::visit(pack);
    }
    std::vector<int> visited;
};

// What a walk leaves out of sight it would find out of reach: a far child is looked at again when
// its turn comes, whether it waited on a stack or not.
TEST(Boxes, WalksWithoutAStackComeToTheSameLeavesAsTheirTwins) {
    for (const auto& triangles : {hills(24), soup(1000, 0.3f), city(8)}) {
        const BvhCase scene(triangles);
        for (const Ray& ray : any_rays(2000)) {
            const auto visited = [&](BoxWalk kind) {
                const std::vector<TrianglePack>& packs = scene.packs(kind);
                const Leaves leaves{{packs.data(), int(packs.size())},
                                    {triangles.data(), int(triangles.size())}};
                Recorder query(leaves, ray);
                scene.walk(kind, query);
                return query.visited;
            };
            ASSERT_EQ(visited(BoxWalk::trail), visited(BoxWalk::stack));
            ASSERT_EQ(visited(BoxWalk::parent), visited(BoxWalk::stack));
            ASSERT_EQ(visited(BoxWalk::wide_trail), visited(BoxWalk::wide_stack));
        }
    }
}

// Over 20000 triangles. The bounds are a third above what was measured when they were written.
TEST(Boxes, ARayVisitsFewNodes) {
    const BvhCase scene(hills(100));
    const std::vector<Ray> rays = rays_down(3000);
    const struct {
        BoxWalk walk;
        double nodes, packs;
    } most[] = {{BoxWalk::stack, 28, 2.2},        {BoxWalk::trail, 31, 2.2},
                {BoxWalk::parent, 57, 2.2},       {BoxWalk::skip, 77, 3.7},
                {BoxWalk::wide_stack, 11.5, 2.2}, {BoxWalk::wide_trail, 11.5, 2.2}};
    for (const auto& [walk, most_nodes, most_packs] : most) {
        double nodes = 0, packs = 0;
        for (const Ray& ray : rays) {
            const WalkCounts counts = scene.answer(walk, ray).closest;
            nodes += counts.nodes / double(rays.size());
            packs += counts.packs / double(rays.size());
        }
        EXPECT_LE(nodes, most_nodes) << name(walk);
        EXPECT_LE(packs, most_packs) << name(walk);
    }
}

} // namespace

} // namespace raylab::lab04
