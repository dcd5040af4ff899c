// The tree over spheres and quads: what a walk finds is what testing all of them finds, to the last
// bit of t, and what a walk visits grows like the logarithm of their number.
#include "common/geometry/make_quad.h"
#include "common/scene/quad_groups.h"
#include "common/scene/shape_boxes.h"
#include "common/scene/sphere_groups.h"
#include "labs/04_accel/bvh/walk_trail.h"
#include "labs/04_accel/shapes/query.h"
#include "labs/04_accel/tests/cases.h"

#include <gtest/gtest.h>

namespace raylab::lab04 {

namespace {

// As the loader lays a scene's shapes, and the tree over them.
struct Shapes {
    Scene scene;
    BvhTree tree;

    // ids: in the order of adding, in steps, spheres and quads in turns.
    int next_id() const {
        return 3 + 2 * static_cast<int>(scene.spheres.size() + scene.quads.size());
    }
    void add(Vec3 center, float radius) {
        Sphere sphere{};
        sphere.center = center, sphere.radius = radius;
        sphere.tags = {next_id(), 0, -1};
        scene.spheres.push_back(sphere);
    }
    void add_quad(Vec3 p, Vec3 a, Vec3 b) {
        const Vec3 v[4] = {p, p + a, p + a + b, p + b};
        scene.quads.push_back(make_quad(v, {next_id(), 0, -1}));
    }
    void build() {
        sort_into_groups(scene.spheres);
        sort_into_groups(scene.quads);
        scene.sphere_groups = group_spheres(scene.spheres);
        scene.quad_groups = group_quads(scene.quads);
        tree = build_shape_tree(scene);
    }
    ShapeTreeView tree_view() const {
        const SceneView all = view(scene);
        return {{{tree.nodes.data(), static_cast<int>(tree.nodes.size())}},
                all.sphere_groups,
                all.quad_groups};
    }
};

Answer one_by_one(const Scene& scene, const Ray& ray) {
    Hit hit;
    float t;
    for (const Sphere& sphere : scene.spheres)
        if (intersect(sphere, ray, t) && hit.is_beaten_by(t, sphere.tags.id))
            hit = {t, sphere.tags.id, Shape::sphere, 0};
    for (const Quad& quad : scene.quads)
        if (intersect(quad, ShearedRay(ray), t) && hit.is_beaten_by(t, quad.tags.id))
            hit = {t, quad.tags.id, Shape::quad, 0};
    return {hit.t, hit.id, hit.found(), {}, false};
}

Answer walked(const Shapes& shapes, const Ray& ray) {
    const SceneView scene = view(shapes.scene);
    const ShapeTreeView tree = shapes.tree_view();
    ClosestShape closest(scene, tree, ray, Hit{});
    walk_bvh_trail(tree.boxes, closest);
    AnyShape any(scene, tree, ray);
    walk_bvh_trail(tree.boxes, any);
    return {closest.hit().t, closest.hit().id, any.found(), closest.counts(),
            closest.endless() || any.endless()};
}

void expect_what_one_by_one_finds(const Shapes& shapes, const std::vector<Ray>& rays,
                                  const char* what) {
    ASSERT_GT(shapes.tree.nodes.size(), 0u) << what;
    std::vector<Answer> truths;
    int hits = 0;
    for (const Ray& ray : rays) {
        truths.push_back(one_by_one(shapes.scene, ray));
        hits += truths.back().any;
    }
    EXPECT_GT(hits, 20) << what << ": too few hits to tell";
    EXPECT_EQ(difference(truths, what, rays, [&](const Ray& ray) { return walked(shapes, ray); }),
              "");
}

// From anywhere past the rim of a sphere: some hit it by the last bit of double, others miss it.
// Every third along an axis, where a box has no room in t, only in space.
std::vector<Ray> rays_at_rims(const std::vector<Sphere>& spheres, int n) {
    Dice dice(12);
    std::vector<Ray> rays;
    for (int i = 0; i < n; ++i) {
        const Sphere& sphere = spheres[dice.below(static_cast<int>(spheres.size()))];
        Vec3 d = dice.direction(), side = normalize(cross(d, dice.direction()));
        if (i % 3 == 0) {
            d = side = Vec3(0);
            const int axis = dice.below(3);
            d[axis] = dice.below(2) ? 1.0f : -1.0f;
            side[(axis + 1 + dice.below(2)) % 3] = dice.below(2) ? 1.0f : -1.0f;
        }
        const double back = dice.between(0, 4);
        Vec3 o(DVec3(sphere.center) + double(sphere.radius) * DVec3(side) - back * DVec3(d));
        if (i % 5 == 0) o = glm::mix(o, Vec3(sphere.center), 0x1p-23f);
        rays.push_back({o, d, i % 7 == 0 ? static_cast<float>(back) : infinity});
    }
    return rays;
}

TEST(ShapeTree, FindsWhatOneByOneFinds) {
    Dice dice(11);
    Shapes scattered, nested, touching, sizes, sheets;
    for (int i = 0; i < 1500; ++i) {
        scattered.add(dice.point(-1, 1), dice.between(0.01f, 0.1f));
        if (i % 5 == 0) scattered.add(scattered.scene.spheres.back().center, 0.1f); // nested
        if (i % 50 == 0) scattered.scene.spheres.push_back(scattered.scene.spheres.back()); // a tie
        sizes.add(dice.point(-1, 1), std::ldexp(1.0f, -dice.below(24)));
        sizes.add_quad(dice.point(-1, 1), dice.between(0, 2) * dice.direction(),
                       std::ldexp(1.0f, -dice.below(16)) * dice.direction());
    }
    for (int i = 0; i < 400; ++i) nested.add(Vec3(0.1f, 0.2f, 0.3f), std::ldexp(1.0f, i % 40 - 30));
    for (int i = 0; i < 1000; ++i)
        touching.add(Vec3(i % 10, i / 10 % 10, i / 100) / 5.0f - 0.9f, 0.1f);
    for (int i = 0; i < 1500; ++i) // in planes of a grid, with common edges
        sheets.add_quad(Vec3(dice.below(9) - 4, dice.below(9) - 4, dice.below(9) - 4) / 4.0f,
                        i % 3 ? Vec3(0.25f, 0, 0) : Vec3(0, 0.25f, 0),
                        i % 2 ? Vec3(0, 0, 0.25f) : Vec3(0.1f, 0.1f, 0.2f));
    for (const auto& [shapes, what] :
         {std::pair(&scattered, "scattered"), std::pair(&nested, "nested"),
          std::pair(&touching, "touching"), std::pair(&sizes, "of all sizes"),
          std::pair(&sheets, "sheets")}) {
        shapes->build();
        expect_what_one_by_one_finds(*shapes, any_rays(1500), what);
        expect_what_one_by_one_finds(*shapes, grid_rays(1500), what);
        if (!shapes->scene.spheres.empty())
            expect_what_one_by_one_finds(*shapes, rays_at_rims(shapes->scene.spheres, 3000), what);
    }
}

// A walk's answer must not depend on which shapes came before: it begins with their hit.
TEST(ShapeTree, BeginsWithTheHitSoFar) {
    Shapes shapes;
    Dice dice(13);
    for (int i = 0; i < 400; ++i) shapes.add(dice.point(-1, 1), 0.1f);
    shapes.build();
    const SceneView scene = view(shapes.scene);
    const ShapeTreeView tree = shapes.tree_view();
    int kept = 0, beaten = 0;
    for (const Ray& ray : any_rays(500)) {
        const Answer alone = walked(shapes, ray);
        if (!alone.any) continue;
        for (const int id : {alone.id - 1, alone.id + 1}) { // at the same t: the lower id wins
            ClosestShape query(scene, tree, ray, {alone.t, id, Shape::triangle, 5});
            walk_bvh_trail(tree.boxes, query);
            EXPECT_EQ(query.hit().id, std::min(id, alone.id));
            ++(id < alone.id ? kept : beaten);
        }
    }
    EXPECT_GT(kept, 50);
    EXPECT_GT(beaten, 50);
}

// n spheres that fill the same share of the cube whatever n: nodes and groups a ray.
WalkCounts visited(int n, bool mixed) {
    Dice dice(14);
    Shapes shapes;
    const float radius = 0.3f / std::cbrt(static_cast<float>(n));
    for (int i = 0; i < n; ++i)
        shapes.add(dice.point(-1, 1),
                   mixed ? radius * std::ldexp(1.0f, 1 - dice.below(8)) : radius);
    shapes.build();
    WalkCounts sum;
    const std::vector<Ray> rays = any_rays(400);
    for (const Ray& ray : rays) {
        const WalkCounts counts = walked(shapes, ray).closest;
        sum.nodes += counts.nodes, sum.packs += counts.packs;
    }
    return sum;
}

// Ten times as many spheres that fill the same share of space are 2.15 times as close, and the tree
// is three or four levels deeper: a ray visits at most 2.5 times as much. Groups are ten times as
// many.
TEST(ShapeTree, TenTimesAsManySpheresDoNotCostTenTimesAsMuch) {
    for (const bool mixed : {false, true}) {
        const WalkCounts few = visited(1000, mixed), more = visited(10000, mixed),
                         many = visited(100000, mixed);
        EXPECT_LT(more.packs, 2.5 * few.packs) << mixed;
        EXPECT_LT(many.packs, 2.5 * more.packs) << mixed;
        EXPECT_LT(more.nodes, 2.5 * few.nodes) << mixed;
        EXPECT_LT(many.nodes, 2.5 * more.nodes) << mixed;
        EXPECT_LT(few.packs, 400u * 2) << mixed; // of 63 each
        RecordProperty(mixed ? "mixed" : "equal",
                       fmt::format("{} {} {}; {} {} {}", few.nodes, more.nodes, many.nodes,
                                   few.packs, more.packs, many.packs));
    }
}

TEST(ShapeTree, AFewGroupsHaveNone) {
    Shapes shapes;
    for (int i = 0; i < few_groups * spheres_per_group; ++i) shapes.add(Vec3(i, 0, 0), 0.1f);
    shapes.build();
    EXPECT_EQ(shapes.tree.nodes.size(), 0u);
    shapes.add(Vec3(0), 0.1f);
    shapes.build();
    EXPECT_EQ(shapes.tree.nodes.size(), std::size_t{few_groups}); // a leaf more than nodes
    EXPECT_LE(shapes.tree.depth, 4);
}

} // namespace

} // namespace raylab::lab04
