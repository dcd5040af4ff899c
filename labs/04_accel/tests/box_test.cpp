// What the walks through boxes rely on: no box that a ray meets is missed, boxes on the grid
// contain the boxes they stand for, trees are no deeper than promised, and orders are whole.
#include "common/geometry/tests/support.h"
#include "labs/04_accel/tests/bvh_cases.h"

#include <algorithm>

namespace raylab::lab04 {

namespace {

using test::Real;

// A tree over boxes alone: leaf i has box i, and a pack with the one index i.
struct BoxTree {
    std::vector<Bounds> boxes;
    BvhTree tree;

    Bounds build(int first, int last, int parent, int side, Dice& dice) {
        if (last - first == 1) {
            hang_leaf(parent, side, boxes[first]);
            return boxes[first];
        }
        const int self = int(tree.nodes.size());
        tree.nodes.push_back({{}, {no_child, no_child}, parent, dice.below(3)});
        const int middle = first + 1 + dice.below(last - first - 1);
        Bounds box = build(first, middle, self, 0, dice);
        box.include(build(middle, last, self, 1, dice));
        if (parent >= 0) hang(parent, side, self, box);
        return box;
    }

    // Leaves come in the order of their boxes.
    void hang_leaf(int node, int side, const Bounds& box) {
        const int leaf = int(tree.packs.size());
        tree.packs.push_back({{}, {leaf, -1, -1, -1}});
        hang(node, side, ~leaf, box);
    }

    void hang(int node, int side, int child, const Bounds& box) {
        tree.nodes[node].child[side] = child;
        for (int axis = 0; axis < 3; ++axis) {
            tree.nodes[node].box[axis][0][side] = box.low[axis];
            tree.nodes[node].box[axis][1][side] = box.high[axis];
        }
    }
};

float power(Dice& dice, int from, int to) {
    return std::ldexp(1.0f, from + dice.below(to - from + 1));
}

// Boxes of all sizes, flat ones among them, around a place that may be far away.
BoxTree any_boxes(int n, Dice& dice) {
    BoxTree made;
    const float size = power(dice, -30, 30);
    const Vec3 place = dice.below(2) ? dice.point(-size, size) * power(dice, 0, 20) : Vec3(0);
    for (int i = 0; i < n; ++i) {
        Bounds box;
        const float extent = size * power(dice, -12, 0);
        const Vec3 p = place + dice.point(-size, size);
        box.include(p);
        box.include(p + dice.point(-extent, extent));
        if (const int flat = dice.below(6); flat < 3) box.high[flat] = box.low[flat];
        made.boxes.push_back(box);
    }
    made.build(0, n, -1, 0, dice);
    return made;
}

Bounds grid_box(const WideNode& node, int slot) {
    Bounds box;
    for (int axis = 0; axis < 3; ++axis) {
        // Of a float and a number of ten bits and a power of two, rounded as between_faces() does.
        box.low[axis] =
            float(node.origin[axis] + double(node.step) * grid_face(node, slot, axis, 0));
        box.high[axis] =
            float(node.origin[axis] + double(node.step) * grid_face(node, slot, axis, 1));
    }
    return box;
}

bool contains(const WideNode& node, int slot, const Bounds& inner) {
    for (int axis = 0; axis < 3; ++axis) {
        const double origin = node.origin[axis], step = node.step;
        if (origin + step * grid_face(node, slot, axis, 0) > inner.low[axis] ||
            origin + step * grid_face(node, slot, axis, 1) < inner.high[axis])
            return false;
    }
    return true;
}

// Calls visit(node, slot, leaf) for each slot of the wide tree, with each leaf below it; returns
// the leaves below `at`.
template <class Visit>
std::vector<int> for_each_slot(const WideTree& tree, int at, const Visit& visit) {
    const WideNode& node = tree.nodes[at];
    std::vector<int> all;
    for (int slot = 0; slot < wide_children; ++slot) {
        std::vector<int> below;
        if (node.leaf >> slot & 1)
            below = {tree.packs[pack_in(node, slot)].index[0]};
        else if (node.inner >> slot & 1)
            below = for_each_slot(tree, child_in(node, slot), visit);
        for (const int leaf : below) visit(at, slot, leaf);
        all.insert(all.end(), below.begin(), below.end());
    }
    return all;
}

TEST(WideBoxes, ContainTheBoxesTheyStandFor) {
    Dice dice(31);
    for (int i = 0; i < test::rays(2000, 100000); ++i) {
        const int n = 2 + dice.below(60);
        const BoxTree made = any_boxes(n, dice);
        const WideTree wide = build_wide(made.tree);
        int outside = 0;
        std::vector<int> leaves = for_each_slot(wide, 0, [&](int node, int slot, int leaf) {
            outside += !contains(wide.nodes[node], slot, made.boxes[leaf]);
        });
        ASSERT_EQ(outside, 0) << "of " << n << " boxes";
        std::sort(leaves.begin(), leaves.end());
        ASSERT_EQ(int(leaves.size()), n);
        for (int leaf = 0; leaf < n; ++leaf) ASSERT_EQ(leaves[leaf], leaf);
    }
}

// A box is no wider than it is by more than a step on either side.
TEST(WideBoxes, AreTight) {
    Dice dice(32);
    for (int i = 0; i < 500; ++i) {
        const BoxTree made = any_boxes(8, dice);
        const WideTree wide = build_wide(made.tree);
        for_each_slot(wide, 0, [&](int at, int slot, int leaf) {
            const WideNode& node = wide.nodes[at];
            if (!(node.leaf >> slot & 1)) return;
            const Bounds grid = grid_box(node, slot), &box = made.boxes[leaf];
            for (int axis = 0; axis < 3; ++axis) {
                ASSERT_GE(grid.low[axis], box.low[axis] - 1.001f * node.step);
                ASSERT_LE(grid.high[axis], box.high[axis] + 1.001f * node.step);
            }
        });
    }
}

TEST(WideBoxes, EachOrderHasEachSlotOnce) {
    for (const auto& triangles : {hills(24), soup(1000, 0.3f), soup(5, 1)}) {
        for (const WideNode& node : build_wide(build_bvh_sah(triangles)).nodes) {
            const int slots = count_bits(wide_slots(node));
            for (const std::uint32_t order : node.order) {
                std::uint32_t seen = 0;
                for (int place = 0; place < slots; ++place) seen |= 1u << (order >> 3 * place & 7);
                ASSERT_EQ(seen, wide_slots(node));
            }
        }
    }
}

// A tree as deep as there may be: on each level of a chain hangs a bush of seven leaves, so large
// that the plan would make them seven children, and the rest of the chain the eighth.
TEST(WideBoxes, AChainHasNoMoreLevelsThanPromised) {
    BoxTree made;
    const int chain = max_sah_depth - 3;
    int parent = -1;
    for (int level = 0; level < chain; ++level) {
        const int self = int(made.tree.nodes.size());
        made.tree.nodes.push_back({{}, {no_child, no_child}, parent, 0});
        const float tiny = std::ldexp(1.0f, -level);
        if (parent >= 0) made.hang(parent, 1, self, {Vec3(0), Vec3(tiny)});
        // Six nodes as in a heap, and their seven leaves.
        const int first = int(made.tree.nodes.size());
        const Bounds large{Vec3(0), Vec3(2 * tiny)};
        for (int k = 0; k < 13; ++k) {
            const int above = k == 0 ? self : first + (k - 1) / 2, side = k == 0 ? 0 : (k - 1) % 2;
            if (k < 6) {
                made.tree.nodes.push_back({{}, {no_child, no_child}, above, 0});
                made.hang(above, side, first + k, large);
            } else {
                made.hang_leaf(above, side, large);
            }
        }
        parent = self;
    }
    made.hang_leaf(parent, 1, {Vec3(0), Vec3(0)}); // the end of the chain

    const WideTree wide = build_wide(made.tree);
    EXPECT_LE(wide.levels, max_wide_levels);
    std::vector<int> leaves = for_each_slot(wide, 0, [](int, int, int) {});
    std::sort(leaves.begin(), leaves.end());
    ASSERT_EQ(leaves.size(), made.tree.packs.size());
    for (int i = 0; i < int(leaves.size()); ++i) EXPECT_EQ(leaves[i], i);
}

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
    const float away = size * power(dice, -10, 20);
    Vec3 o = dice.below(4) > 0 ? target + away * dice.direction() : place_in();
    for (int axis = 0; axis < 3; ++axis)
        if (dice.below(6) == 0) o[axis] = target[axis];
    Vec3 d = target - o;
    if (!(dot(d, d) > 0)) d = dice.direction();
    for (int axis = 0; axis < 3; ++axis) {
        const int way = dice.below(12);
        if (way == 0) d[axis] = std::copysign(0.0f, d[axis]);
        if (way == 1) d[axis] = -0.0f;
        if (way == 2) d[axis] *= power(dice, -120, -30);
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
