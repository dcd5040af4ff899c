// The KD-tree against the suite of hard cases (KD-PLANE, ACCEL-BRUTE, TREE-DEPTH, DUP-COPLANAR,
// BOX-FACE, BOX-FLAT, TRI-DEGEN, TRI-EDGE, POW2-SCALE): every walk finds what brute force finds.
#include "common/geometry/tests/support.h"
#include "labs/04_accel/tests/kd_cases.h"

#include <algorithm>
#include <limits>

namespace raylab::lab04 {

namespace {

void expect_equal_to_brute_force(const KdCase& scene, const std::vector<Ray>& rays,
                                 const std::string& what) {
    for (const KdWalk kind : kd_walks) EXPECT_EQ(difference(scene, kind, rays), "") << what;
}

// Over the tree as it is by default, and over one with as many planes as can be.
void expect_equal_to_brute_force(const std::vector<Triangle>& triangles,
                                 const std::vector<Ray>& rays, const std::string& what) {
    expect_equal_to_brute_force(KdCase(triangles), rays, what);
    expect_equal_to_brute_force(KdCase(triangles, deep()), rays, what + ", many planes");
}

// In the faces of the tree's own cells, along and across them, and from and to their corners. No
// component of d is so small, but 0, that a flat triangle is seen from less than 2^-20 above its
// plane: there the triangle test itself takes a ray to meet what it passes by (see edge_error()).
std::vector<Ray> rays_in_split_planes(const KdTree& tree, int n) {
    Dice dice(4);
    std::vector<Ray> rays;
    while (int(rays.size()) < n) {
        const Bounds& cell = tree.leaves[dice.below(int(tree.leaves.size()))].cell;
        const Bounds& other = tree.leaves[dice.below(int(tree.leaves.size()))].cell;
        Vec3 o, d;
        const bool to_corner = dice.below(4) == 0;
        for (int axis = 0; axis < 3; ++axis) {
            const float low = cell.low[axis], high = cell.high[axis];
            const float places[] = {low, high, dice.between(low, high),
                                    dice.between(tree.bounds.low[axis], tree.bounds.high[axis])};
            const float ways[] = {0.0f, -0.0f, 1, -1, dice.between(-1, 1)};
            o[axis] = places[dice.below(4)];
            d[axis] = to_corner ? (dice.below(2) ? other.low[axis] : other.high[axis]) - o[axis]
                                : ways[dice.below(5)];
        }
        if (!(dot(d, d) > 0)) continue;
        d = normalize(d);
        for (int axis = 0; axis < 3; ++axis)
            if (float& x = d[axis]; std::fabs(x) < 0x1p-20f) x = std::copysign(0.0f, x);
        rays.push_back({o, d});
    }
    return rays;
}

TEST(KdTree, AccelBrute) {
    const int n = test::rays(1500, 100000);
    const auto rays = any_rays(n);
    for (const auto& [what, triangles] : {std::pair{"soup", soup(1000, 0.3f)},
                                          {"dust", soup(4000, 0.02f)},
                                          {"hills", hills(24)},
                                          {"city", city(8)},
                                          {"grid", on_grid(400)}}) {
        expect_equal_to_brute_force(triangles, rays, what);
        expect_equal_to_brute_force(triangles, rays_at_edges(triangles, n), what);
    }
}

// As kd/ray.h says; so none looks further than another.
TEST(KdTree, WalksComeToTheSameLeaves) {
    for (const auto& triangles : {soup(500, 0.3f), hills(24)}) {
        const KdCase scene(triangles, deep());
        for (const Ray& ray : any_rays(2000)) {
            const WalkCounts stack = scene.answer(KdWalk::stack, ray).closest,
                             ropes = scene.answer(KdWalk::ropes, ray).closest,
                             restart = scene.answer(KdWalk::restart, ray).closest;
            ASSERT_EQ(ropes.packs, stack.packs);
            ASSERT_EQ(restart.packs, stack.packs);
            ASSERT_GE(restart.nodes, ropes.nodes);
        }
    }
}

TEST(KdTree, KdPlane) {
    const int n = test::rays(6000, 300000);
    expect_equal_to_brute_force(on_grid(400), grid_rays(n), "grid");
    expect_equal_to_brute_force(city(5), grid_rays(n), "city");
    for (const auto& triangles : {on_grid(500), hills(12), soup(300, 0.3f), city(5)}) {
        const KdCase scene(triangles, deep());
        ASSERT_GT(scene.tree.leaves.size(), 100u);
        expect_equal_to_brute_force(scene, rays_in_split_planes(scene.tree, n), "split planes");
    }
}

TEST(KdTree, TreeDepth) {
    std::vector<Triangle> same = identical(100000), sizes = nested(), outlier = hills(40);
    add(outlier, {0x1p30f, 0, 0}, {0x1p30f, 1, 0}, {0x1p30f, 0, 1});
    for (const auto& settings : {KdBuildSettings{}, deep()}) {
        for (const auto* triangles : {&same, &sizes, &outlier}) {
            const KdTree tree = build_kd_tree(*triangles, settings);
            EXPECT_LE(depth(tree), kd_depth_limit(triangles->size()));
            EXPECT_LE(kd_depth_limit(triangles->size()), kd_max_depth);
            std::size_t references = 0;
            for (const TrianglePack& pack : tree.packs)
                references += triangles_per_pack -
                              std::count(pack.index, pack.index + triangles_per_pack, -1);
            EXPECT_LE(references, settings.copies * triangles->size());
        }
    }
    EXPECT_EQ(kd_depth_limit(std::size_t{1} << 62), kd_max_depth);

    expect_equal_to_brute_force(KdCase(same), any_rays(20), "one triangle 10^5 times");
    expect_equal_to_brute_force(outlier, any_rays(500), "one far away");
    // At the lower half of the sizes, from their own distance. From 2^40 times the size of a
    // triangle its test says nothing any more.
    std::vector<Ray> rays;
    Dice dice(8);
    for (int i = 0; i < 2000; ++i) {
        const float s = std::ldexp(1.0f, dice.below(32) - 60);
        const Vec3 o = s * dice.point(-2, 2), target = s * dice.point(0, 0.5f);
        rays.push_back({o, normalize(target - o)});
    }
    expect_equal_to_brute_force(sizes, rays, "from 2^-60 to 2^59");
}

// The outlier must not cost the rest its tree.
TEST(KdTree, OneFarTriangleCostsARayLittle) {
    std::vector<Triangle> triangles = hills(60);
    const KdCase near(triangles);
    add(triangles, {0x1p24f, 0, 0}, {0x1p24f, 1, 0}, {0x1p24f, 0, 1});
    const KdCase with_far(triangles);
    double packs[2] = {};
    for (const Ray& ray : any_rays(1000)) {
        packs[0] += near.answer(KdWalk::ropes, ray).closest.packs;
        packs[1] += with_far.answer(KdWalk::ropes, ray).closest.packs;
    }
    EXPECT_LE(packs[1], 2 * packs[0]);
}

TEST(KdTree, DupCoplanar) {
    // Twice and three times the same, with others in the same plane over them, ids shuffled.
    std::vector<Triangle> triangles = city(4);
    const std::vector<Triangle> once = triangles;
    for (const Triangle& t : once) add(triangles, t.v[1], t.v[2], t.v[0]);
    for (const Triangle& t : once) add(triangles, t.v[0], t.v[1], 0.5f * (t.v[1] + t.v[2]));
    for (std::size_t i = 0; i < triangles.size(); ++i)
        triangles[i].tags.id = int(i * 7919 % triangles.size());
    const auto rays = grid_rays(test::rays(2000, 100000));
    expect_equal_to_brute_force(triangles, rays, "coplanar");

    // Their order in the array changes nothing.
    std::vector<Triangle> turned(triangles.rbegin(), triangles.rend());
    const KdCase a(triangles, deep()), b(turned, deep());
    for (const Ray& ray : rays) {
        const Answer one = a.answer(KdWalk::ropes, ray), other = b.answer(KdWalk::ropes, ray);
        ASSERT_EQ(one.id, other.id);
        ASSERT_EQ(one.t, other.t);
    }
}

TEST(KdTree, BoxFlat) {
    std::vector<Triangle> floor, walls;
    for (int i = 0; i < 12; ++i) {
        for (int j = 0; j < 12; ++j) {
            const float x = i / 6.0f - 1, z = j / 6.0f - 1, w = 1 / 6.0f;
            add(floor, {x, 0, z}, {x + w, 0, z}, {x + w, 0, z + w});
            add(walls, {x, z, 0.1f * (i % 3)}, {x + w, z, 0.1f * (i % 3)},
                {x, z + w, 0.1f * (i % 3)});
        }
    }
    for (const auto& triangles : {floor, walls}) {
        expect_equal_to_brute_force(triangles, any_rays(1500), "flat");
        expect_equal_to_brute_force(triangles, rays_at_edges(triangles, 1500), "flat, edges");
        const KdCase scene(triangles, deep());
        expect_equal_to_brute_force(scene, rays_in_split_planes(scene.tree, 3000), "flat, planes");
    }
}

TEST(KdTree, TriDegen) {
    std::vector<Triangle> good = hills(10), all = good;
    add(all, {0, 0, 0}, {1, 1, 1}, {2, 2, 2});               // no area
    add(all, {0, 1, 0}, {0, 1, 0}, {1, 0, 0});               // a corner twice
    add(all, {0, nan, 0}, {1, 0, 0}, {0, 0, 1});             // no place
    add(all, {infinity, 0, 0}, {1, 0, 0}, {0, 0, 1});        // no end
    add(all, {-1, 0.1f, 0}, {1, 0.1f, 0}, {1, 0.1f, 1e-6f}); // a needle, which may be hit
    add(good, {-1, 0.1f, 0}, {1, 0.1f, 0}, {1, 0.1f, 1e-6f});
    good.back().tags.id = all.back().tags.id;
    const auto rays = any_rays(2000);
    expect_equal_to_brute_force(all, rays, "with degenerate ones");
    const KdCase with(all), without(good);
    for (const Ray& ray : rays) {
        const Answer a = with.answer(KdWalk::stack, ray), b = without.answer(KdWalk::stack, ray);
        ASSERT_EQ(a.id, b.id);
        ASSERT_EQ(a.t, b.t);
    }
    all = {all.begin() + 200, all.begin() + 204}; // nothing that can be hit
    EXPECT_TRUE(build_kd_tree(all).nodes.empty());
    expect_equal_to_brute_force(all, rays, "only degenerate ones");
}

TEST(KdTree, TriEdge) {
    const test::Mesh sphere = test::icosphere(3, 1, DVec3(0));
    std::vector<Triangle> triangles;
    for (int f = 0; f < int(sphere.faces.size()); ++f) {
        const Triangle t = sphere.triangle(f);
        add(triangles, t.v[0], t.v[1], t.v[2]);
    }
    std::vector<Ray> rays = rays_at_edges(triangles, test::rays(3000, 300000));
    for (Ray& ray : rays) {
        const Vec3 target = ray.o + ray.d;
        ray.o *= 0.25f; // inside
        ray.d = normalize(target - ray.o);
    }
    Dice dice(9);
    for (const Vec3& v : sphere.vertices) {
        const Vec3 o = dice.point(-0.5f, 0.5f);
        rays.push_back({o, normalize(v - o)});
        rays.push_back({Vec3(0), normalize(v)});
    }
    const KdCase scene(triangles, deep());
    for (const Ray& ray : rays)
        for (const KdWalk kind : kd_walks) ASSERT_TRUE(scene.answer(kind, ray).any) << name(kind);
    expect_equal_to_brute_force(scene, rays, "icosphere");
}

TEST(KdTree, Pow2Scale) {
    const std::vector<Triangle> triangles = soup(300, 0.3f);
    const KdCase scene(triangles, deep());
    const auto rays = any_rays(300);
    for (const int k : {-40, -20, 20, 40}) {
        const float scale = std::ldexp(1.0f, k);
        std::vector<Triangle> larger = triangles;
        for (Triangle& triangle : larger)
            for (Vec3& v : triangle.v) v *= scale;
        const KdCase scaled(larger, deep());
        ASSERT_EQ(scaled.tree.nodes.size(), scene.tree.nodes.size());
        for (std::size_t i = 0; i < scene.tree.nodes.size(); ++i) {
            ASSERT_EQ(scaled.tree.nodes[i].tail, scene.tree.nodes[i].tail);
            if (!scene.tree.nodes[i].is_leaf()) {
                ASSERT_EQ(scaled.tree.nodes[i].split, scene.tree.nodes[i].split * scale);
            }
        }
        for (const Ray& ray : rays) {
            const Ray longer{ray.o * scale, ray.d, ray.t_max * scale};
            for (const KdWalk kind : kd_walks) {
                const Answer one = scene.answer(kind, ray), other = scaled.answer(kind, longer);
                ASSERT_EQ(other.id, one.id);
                ASSERT_EQ(other.t, one.t * scale);
                ASSERT_EQ(other.closest.nodes, one.closest.nodes);
            }
        }
    }
}

TEST(KdTree, FarOriginsAndOddRays) {
    const KdCase scene(hills(16), deep());
    std::vector<Ray> rays;
    Dice dice(10);
    for (int i = 0; i < 2000; ++i) {
        const Vec3 o = 200.0f * dice.direction(), target = dice.point(-1, 1);
        rays.push_back({o, normalize(target - o)});
    }
    expect_equal_to_brute_force(scene, rays, "from 200 scenes away");
    for (const Ray& ray : {Ray{Vec3(nan), Vec3(1, 0, 0)}, Ray{Vec3(0), Vec3(nan)},
                           Ray{Vec3(0), Vec3(0)}, Ray{Vec3(infinity), Vec3(0, 1, 0)},
                           Ray{Vec3(0), Vec3(0, 1, 0), nan}, Ray{Vec3(0), Vec3(0, 1, 0), 0}})
        for (const KdWalk kind : kd_walks) EXPECT_FALSE(scene.answer(kind, ray).endless);
}

// What the walks rely on: a point of a triangle lies in no leaf that does not hold the triangle.
TEST(KdTree, LeavesHoldWhatReachesIntoThem) {
    for (const auto& triangles : {soup(400, 0.3f), hills(12), on_grid(400), city(5)}) {
        const KdCase scene(triangles, deep());
        const KdTree& tree = scene.tree;
        Dice dice(11);
        int missing = 0;
        for (int i = 0; i < 20000; ++i) {
            const int index = dice.below(int(triangles.size()));
            const Vec3* v = triangles[index].v;
            const float weights[] = {0, 0.5f, 1, dice.between(0, 1)};
            const DVec3 ab = glm::mix(DVec3(v[0]), DVec3(v[1]), double(weights[dice.below(4)]));
            const DVec3 p = glm::mix(ab, DVec3(v[2]), double(weights[dice.below(4)]));
            int at = 0;
            while (!tree.nodes[at].is_leaf()) {
                const KdNode& node = tree.nodes[at];
                const double x = p[node.axis()];
                const bool above = x == node.split ? dice.below(2) : x > node.split;
                at = above ? node.above() : node.below();
            }
            bool found = false;
            const KdNode& leaf = tree.nodes[at];
            for (int b = leaf.first_pack; b < leaf.first_pack + leaf.packs(); ++b)
                for (const int other : tree.packs[b].index) found |= other == index;
            missing += !found;
        }
        EXPECT_EQ(missing, 0);
    }
}

} // namespace

} // namespace raylab::lab04
