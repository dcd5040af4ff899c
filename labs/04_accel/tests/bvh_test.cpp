// The hierarchies of boxes against the suite of hard cases (ACCEL-BRUTE, TREE-DEPTH, DUP-COPLANAR,
// BOX-FACE, BOX-FLAT, TRI-DEGEN, TRI-EDGE, POW2-SCALE): every walk finds what brute force finds.
#include "common/geometry/tests/support.h"
#include "labs/04_accel/lbvh/build.h"
#include "labs/04_accel/tests/bvh_cases.h"

#include <algorithm>
#include <limits>

namespace raylab::lab04 {

namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

// Without a wide tree: that one is made of the other binary trees.
BvhCase along_the_curve(const std::vector<Triangle>& triangles) {
    const DeviceArray<Triangle> on_device(triangles);
    return {triangles, to_host(build_lbvh({on_device.data(), int(triangles.size())}))};
}

void expect_truth(const BvhCase& scene, const std::vector<Ray>& rays,
                  const std::vector<Answer>& truths, const std::string& what) {
    for (const BoxWalk kind : box_walks) {
        if (is_wide(kind) && scene.wide.nodes.empty()) continue;
        EXPECT_EQ(difference(truths, name(kind), rays,
                             [&](const Ray& ray) { return scene.answer(kind, ray); }),
                  "")
            << what;
    }
}

void expect_equal_to_brute_force(const BvhCase& scene, const std::vector<Ray>& rays,
                                 const std::string& what) {
    const std::vector<Answer> truths = brute_force(scene.triangles, rays);
    expect_truth(scene, rays, truths, what);
    expect_truth(along_the_curve(scene.triangles), rays, truths, what + ", along the Morton curve");
}

void expect_equal_to_brute_force(const std::vector<Triangle>& triangles,
                                 const std::vector<Ray>& rays, const std::string& what) {
    expect_equal_to_brute_force(BvhCase(triangles), rays, what);
}

// Two trees, every walk: the same hit, the same t.
void expect_equal_answers(const BvhCase& a, const BvhCase& b, const std::vector<Ray>& rays) {
    for (const Ray& ray : rays)
        for (const BoxWalk kind : box_walks)
            ASSERT_TRUE(same(a.answer(kind, ray), b.answer(kind, ray))) << name(kind);
}

const std::vector<std::pair<const char*, std::vector<Triangle>>>& meshes() {
    static const std::vector<std::pair<const char*, std::vector<Triangle>>> all = {
        {"soup", soup(1000, 0.3f)}, {"dust", soup(4000, 0.02f)}, {"hills", hills(24)},
        {"city", city(8)},          {"grid", on_grid(400)},
    };
    return all;
}

TEST(Boxes, AccelBrute) {
    const int n = test::rays(1000, 100000);
    for (const auto& [what, triangles] : meshes()) {
        const BvhCase scene(triangles);
        expect_equal_to_brute_force(scene, any_rays(n), what);
        expect_equal_to_brute_force(scene, rays_at_edges(triangles, n), what);
        expect_equal_to_brute_force(scene, grid_rays(n), what);
    }
}

// A ray ends just before, at, and just behind what it would hit.
TEST(Boxes, RaysMayEndAtTheHit) {
    const BvhCase scene(soup(1000, 0.3f));
    std::vector<Ray> rays;
    for (const Ray& ray : any_rays(2000)) {
        const float t = brute_force(scene.triangles, ray).t;
        if (t == infinity) continue;
        for (const float end : {std::nextafter(t, 0.0f), t, std::nextafter(t, infinity)})
            rays.push_back({ray.o, ray.d, end});
    }
    ASSERT_GT(rays.size(), 600u);
    expect_equal_to_brute_force(scene, rays, "up to the hit");
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

// From below, in, between, and above the faces of a closed box, in all 56 directions of 0, -0, 1
// and -1; and boxes that are flat.
TEST(Boxes, BoxFace) {
    const Vec3 low(1, 2, -1), high(2, 4, 0.5f);
    for (const Vec3 size : {high - low, Vec3(1, 2, 0), Vec3(1, 0, 0.5f)}) {
        std::vector<Triangle> triangles;
        const auto quad = [&](Vec3 a, Vec3 u, Vec3 v) {
            add(triangles, a, a + u, a + u + v);
            add(triangles, a, a + u + v, a + v);
        };
        const Vec3 x(size.x, 0, 0), y(0, size.y, 0), z(0, 0, size.z);
        quad(low, x, y), quad(low, y, z), quad(low, z, x);
        quad(low + z, x, y), quad(low + x, y, z), quad(low + y, z, x);
        std::vector<Ray> rays;
        const float ways[] = {0.0f, -0.0f, 1, -1};
        for (int place = 0; place < 125; ++place) {
            Vec3 o;
            for (int axis = 0, p = place; axis < 3; ++axis, p /= 5)
                o[axis] = low[axis] + (p % 5 - 1) * 0.5f * (high - low)[axis];
            for (int way = 0; way < 64; ++way) {
                const Vec3 d(ways[way % 4], ways[way / 4 % 4], ways[way / 16]);
                if (dot(d, d) > 0) rays.push_back({o, normalize(d)});
            }
        }
        expect_equal_to_brute_force(triangles, rays, "a closed box");
    }
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

// So slow along one axis or two, by 2^first to 2^last, that 1 / d, and its products, may leave what
// a float can hold.
std::vector<Ray> almost_parallel_rays(int n, int first, int last) {
    Dice dice(12);
    std::vector<Ray> rays;
    for (int i = 0; i < n; ++i) {
        Vec3 d = dice.direction();
        const int fast = dice.below(3);
        for (int axis = 0; axis < 3; ++axis)
            if (axis != fast && dice.below(4) > 0)
                d[axis] =
                    std::copysign(std::ldexp(1.0f, first - dice.below(first - last + 1)), d[axis]);
        rays.push_back({dice.point(-2, 2), normalize(d)});
    }
    return rays;
}

TEST(Boxes, AlmostParallelRays) {
    const auto rays = almost_parallel_rays(6000, -30, -120);
    for (const auto& [what, triangles] : meshes())
        expect_equal_to_brute_force(triangles, rays, what);
}

// Slower than that, a ray that leaves the plane of a wall has not gone further, where it ends, than
// the exact test's own room (2^-49 of the sizes, see edge_error()): it may still count as on the
// wall, which its box excludes.
TEST(Boxes, RaysThatLeaveThePlanesOfWallsSlowly) {
    auto rays = almost_parallel_rays(6000, -20, -39);
    for (Ray& ray : rays)
        for (int axis = 0; axis < 3; ++axis) ray.o[axis] = std::round(4 * ray.o[axis] + 3);
    expect_equal_to_brute_force(city(8), rays, "city");
    expect_equal_to_brute_force(on_grid(400), rays, "grid");
}

TEST(Boxes, OriginsOnSurfacesAndFaces) {
    for (const auto& [what, triangles] : meshes()) {
        const BvhCase scene(triangles);
        Dice dice(13);
        std::vector<Ray> rays;
        for (int i = 0; i < 1000; ++i) {
            const BvhNode& node = scene.tree.nodes[dice.below(int(scene.tree.nodes.size()))];
            const Bounds box = child_box(node, dice.below(2));
            Vec3 o;
            for (int axis = 0; axis < 3; ++axis) {
                const float places[] = {box.low[axis], box.high[axis],
                                        dice.between(box.low[axis], box.high[axis])};
                o[axis] = places[dice.below(3)];
            }
            rays.push_back({o, dice.direction()});
            const Triangle& t = triangles[dice.below(int(triangles.size()))];
            rays.push_back({(t.v[0] + t.v[1] + t.v[2]) / 3.0f, dice.direction()});
        }
        expect_equal_to_brute_force(scene, rays, what);
    }
}

TEST(Boxes, FarOriginsAndOddRays) {
    const BvhCase scene(hills(16));
    for (const float away : {200.0f, 0x1p20f}) {
        std::vector<Ray> rays;
        Dice dice(10);
        for (int i = 0; i < 2000; ++i) {
            const Vec3 o = away * dice.direction(), target = dice.point(-1, 1);
            rays.push_back({o, normalize(target - o)});
        }
        expect_equal_to_brute_force(scene, rays, fmt::format("from {} away", away));
    }
    for (const Ray& ray : {Ray{Vec3(nan), Vec3(1, 0, 0)}, Ray{Vec3(0), Vec3(nan)},
                           Ray{Vec3(0), Vec3(0)}, Ray{Vec3(infinity), Vec3(0, 1, 0)},
                           Ray{Vec3(0), Vec3(0, 1, 0), nan}, Ray{Vec3(0), Vec3(0, 1, 0), 0}})
        for (const BoxWalk kind : box_walks)
            EXPECT_FALSE(scene.answer(kind, ray).endless) << name(kind);
}

} // namespace

} // namespace raylab::lab04
