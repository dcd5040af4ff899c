// The hierarchies of boxes against rays that are hard (BOX-FACE among them): in faces, along axes
// or almost so, from surfaces and from far away. Every walk finds what brute force finds.
#include "common/geometry/tests/support.h"
#include "labs/04_accel/tests/bvh_hard_cases.h"

#include <limits>

namespace raylab::lab04 {

namespace {

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
