// The hierarchies of boxes against triangles that are hard (ACCEL-BRUTE, TREE-DEPTH, DUP-COPLANAR,
// BOX-FLAT, TRI-DEGEN, TRI-EDGE, POW2-SCALE): every walk finds what brute force finds.
#include "common/geometry/tests/support.h"
#include "labs/04_accel/tests/bvh_hard_cases.h"

#include <algorithm>
#include <limits>

namespace raylab::lab04 {

namespace {

TEST(Boxes, AccelBrute) {
    const int n = test::rays(1000, 100000);
    for (const auto& [what, triangles] : meshes()) {
        const BvhCase scene(triangles);
        expect_equal_to_brute_force(scene, any_rays(n), what);
        expect_equal_to_brute_force(scene, rays_at_edges(triangles, n), what);
        expect_equal_to_brute_force(scene, grid_rays(n), what);
    }
}

TEST(Boxes, FewTriangles) {
    for (const int n : {0, 1, 2, 7, 8, 9, 16, 17, 65}) {
        expect_equal_to_brute_force(soup(n, 1), any_rays(500), std::to_string(n));
        expect_equal_to_brute_force(identical(n), any_rays(100), std::to_string(n) + " identical");
    }
    EXPECT_TRUE(build_bvh_sah({}).nodes.empty());
    EXPECT_TRUE(along_the_curve({}).tree.nodes.empty());
    EXPECT_TRUE(build_wide({}).nodes.empty());
    EXPECT_TRUE(lay_skip_links({}).empty());
}

// Nodes from the root to the deepest leaf, found by going there.
int depth_below(const BvhTree& tree, int node) {
    int deepest = 0;
    for (const int child : tree.nodes[node].child)
        if (!is_leaf(child)) deepest = std::max(deepest, depth_below(tree, child));
    return deepest + 1;
}

TEST(Boxes, TreeDepth) {
    std::vector<Triangle> outlier = hills(40), wider;
    add(outlier, {0x1p30f, 0, 0}, {0x1p30f, 1, 0}, {0x1p30f, 0, 1});
    for (int k = -120; k < 120; ++k) {
        const float s = std::ldexp(1.0f, k);
        for (int i = 0; i < 4; ++i) add(wider, {s, 0, 0}, {0, s, 0}, {0, 0, s});
    }
    for (const auto& triangles : {identical(100000), nested(), outlier, wider}) {
        const BvhTree morton = along_the_curve(triangles).tree;
        EXPECT_EQ(morton.depth, depth_below(morton, 0));
        EXPECT_LE(morton.depth, max_bvh_depth);
        const BvhTree tree = build_bvh_sah(triangles);
        EXPECT_EQ(tree.depth, depth_below(tree, 0));
        EXPECT_LE(tree.depth, max_sah_depth);
        EXPECT_LE(build_wide(tree).levels, max_wide_levels);
        EXPECT_LE(tree.packs.size(), triangles.size());
    }
    EXPECT_GE(build_bvh_sah(wider).depth, max_sah_depth - 4) << "not deep enough to test the cap";

    expect_equal_to_brute_force(identical(100000), any_rays(10), "one triangle 10^5 times");
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
    expect_equal_to_brute_force(nested(), rays, "from 2^-60 to 2^59");
}

// The outlier must not cost the rest its tree. The wide tree it costs an axis: its room for
// rounding is that of the largest coordinate, so its boxes are as good as endless there.
TEST(Boxes, OneFarTriangleCostsARayLittle) {
    std::vector<Triangle> triangles = hills(60);
    const BvhCase near(triangles);
    add(triangles, {0x1p24f, 0, 0}, {0x1p24f, 1, 0}, {0x1p24f, 0, 1});
    const BvhCase with_far(triangles);
    for (const BoxWalk kind : box_walks) {
        if (is_wide(kind)) continue;
        double packs[2] = {};
        for (const Ray& ray : any_rays(500)) {
            packs[0] += near.answer(kind, ray).closest.packs;
            packs[1] += with_far.answer(kind, ray).closest.packs;
        }
        EXPECT_LE(packs[1], 1.5 * packs[0]) << name(kind);
    }
}

TEST(Boxes, DupCoplanar) {
    // Twice and three times the same, with others in the same plane over them, ids shuffled.
    std::vector<Triangle> triangles = city(4);
    const std::vector<Triangle> once = triangles;
    for (const Triangle& t : once) add(triangles, t.v[1], t.v[2], t.v[0]);
    for (const Triangle& t : once) add(triangles, t.v[0], t.v[1], 0.5f * (t.v[1] + t.v[2]));
    for (std::size_t i = 0; i < triangles.size(); ++i)
        triangles[i].tags.id = int(i * 7919 % triangles.size());
    const auto rays = grid_rays(test::rays(2000, 100000));
    const BvhCase scene(triangles);
    expect_equal_to_brute_force(scene, rays, "coplanar");

    // Their order in the array changes nothing.
    const BvhCase turned({triangles.rbegin(), triangles.rend()});
    Dice dice(20);
    for (std::size_t i = triangles.size() - 1; i > 0; --i)
        std::swap(triangles[i], triangles[dice.below(int(i) + 1)]);
    const BvhCase shuffled(triangles);
    expect_equal_answers(scene, turned, rays);
    expect_equal_answers(scene, shuffled, rays);
}

TEST(Boxes, BoxFlat) {
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
        const BvhCase scene(triangles);
        expect_equal_to_brute_force(scene, any_rays(1500), "flat");
        expect_equal_to_brute_force(scene, rays_at_edges(triangles, 1500), "flat, edges");
        expect_equal_to_brute_force(scene, grid_rays(1500), "flat, along the axes");
    }
}

TEST(Boxes, TriDegen) {
    std::vector<Triangle> good = hills(10), all = good;
    add(all, {0, 0, 0}, {1, 1, 1}, {2, 2, 2});               // no area
    add(all, {0, 1, 0}, {0, 1, 0}, {1, 0, 0});               // a corner twice
    add(all, {0, 1, 0}, {0, 1, 0}, {0, 1, 0});               // a point
    add(all, {0, nan, 0}, {1, 0, 0}, {0, 0, 1});             // no place
    add(all, {infinity, 0, 0}, {1, 0, 0}, {0, 0, 1});        // no end
    add(all, {-1, 0.1f, 0}, {1, 0.1f, 0}, {1, 0.1f, 1e-6f}); // a needle, which may be hit
    add(good, {-1, 0.1f, 0}, {1, 0.1f, 0}, {1, 0.1f, 1e-6f});
    good.back().tags.id = all.back().tags.id;
    auto rays = any_rays(2000);
    for (const Ray& ray : rays_at_edges({good.back()}, 500)) rays.push_back(ray);
    const BvhCase with(all);
    expect_equal_to_brute_force(with, rays, "with degenerate ones");
    expect_equal_answers(with, BvhCase(good), rays);
    all = {all.begin() + 203, all.begin() + 205}; // nothing that has a place
    EXPECT_TRUE(build_bvh_sah(all).nodes.empty());
    expect_equal_to_brute_force(all, any_rays(10), "only degenerate ones");
}

TEST(Boxes, TriEdge) {
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
    const BvhCase scene(triangles);
    for (const Ray& ray : rays)
        for (const BoxWalk kind : box_walks) ASSERT_TRUE(scene.answer(kind, ray).any) << name(kind);
    expect_equal_to_brute_force(scene, rays, "icosphere");
}

TEST(Boxes, Pow2Scale) {
    const std::vector<Triangle> triangles = soup(300, 0.3f);
    const BvhCase scene(triangles);
    const auto rays = any_rays(300);
    for (const int k : {-40, -20, 20, 40}) {
        const float scale = std::ldexp(1.0f, k);
        std::vector<Triangle> larger = triangles;
        for (Triangle& triangle : larger)
            for (Vec3& v : triangle.v) v *= scale;
        const BvhCase scaled(larger);
        ASSERT_EQ(scaled.tree.nodes.size(), scene.tree.nodes.size());
        for (std::size_t i = 0; i < scene.tree.nodes.size(); ++i)
            for (int child = 0; child < 2; ++child)
                ASSERT_EQ(scaled.tree.nodes[i].child[child], scene.tree.nodes[i].child[child]);
        ASSERT_EQ(scaled.wide.nodes.size(), scene.wide.nodes.size());
        for (std::size_t i = 0; i < scene.wide.nodes.size(); ++i) {
            ASSERT_EQ(scaled.wide.nodes[i].step, scene.wide.nodes[i].step * scale);
            for (int slot = 0; slot < wide_children; ++slot)
                ASSERT_EQ(scaled.wide.nodes[i].face[0][slot], scene.wide.nodes[i].face[0][slot]);
        }
        const BvhCase morton = along_the_curve(triangles), scaled_morton = along_the_curve(larger);
        for (const Ray& ray : rays) {
            const Ray longer{ray.o * scale, ray.d, ray.t_max * scale};
            const auto expect_scaled = [&](const Answer& one, const Answer& other) {
                ASSERT_EQ(other.id, one.id);
                ASSERT_EQ(other.t, one.t * scale);
                ASSERT_EQ(other.closest.nodes, one.closest.nodes);
                ASSERT_EQ(other.closest.packs, one.closest.packs);
            };
            for (const BoxWalk kind : box_walks) {
                expect_scaled(scene.answer(kind, ray), scaled.answer(kind, longer));
                if (!is_wide(kind))
                    expect_scaled(morton.answer(kind, ray), scaled_morton.answer(kind, longer));
            }
        }
    }
}

} // namespace

} // namespace raylab::lab04
