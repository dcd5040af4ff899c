// Task 1.2: spheres and triangles at points that are known beforehand, and the closest of many
// hits.
#include "common/task/facts.h"
#include "common/task/small_scene.h"
#include "labs/01_recursive/intersect.h"

namespace raylab::lab01 {

namespace {

using namespace task;

std::string text(const Ray& ray) {
    return fmt::format("the ray from ({:g}, {:g}, {:g}) along ({:.4g}, {:.4g}, {:.4g})", ray.o.x,
                       ray.o.y, ray.o.z, ray.d.x, ray.d.y, ray.d.z);
}

Sphere sphere_of(Vec3 center, float radius) { return {center, radius, {0, 0, -1}}; }

bool expect_hit(const Sphere& sphere, const Ray& ray, double expected, double tolerance,
                const std::string& cause) {
    float t = -1;
    return expect(hit_sphere(sphere, ray, t),
                  text(ray) + " should hit the sphere but misses it; the likely cause: " + cause) &&
           expect_near("t of " + text(ray), t, expected, tolerance, cause);
}

bool expect_miss(const Sphere& sphere, const Ray& ray, const std::string& cause) {
    float t = -1;
    return expect(!hit_sphere(sphere, ray, t),
                  fmt::format("{} should miss the sphere but hits it at t = {:g}; the likely "
                              "cause: {}",
                              text(ray), t, cause));
}

// 3-4-5 triangles: with x = 1.2 a sphere of radius 2 is met at z = 1.6.
TEST(Task1_2, ASphereIsMetAtItsNearSide) {
    const Sphere sphere = sphere_of(Vec3(0), 2);
    expect_hit(sphere, {Vec3(0, 0, 5), Vec3(0, 0, -1)}, 3, 1e-6, "the nearer root is wanted");
    expect_hit(sphere, {Vec3(1.2f, 0, 5), Vec3(0, 0, -1)}, 3.4, 1e-6, "b or c has a wrong sign");
    expect_hit(sphere_of(Vec3(3, -4, 1), 2), {Vec3(3, -4 + 1.6f, -9), Vec3(0, 0, 1)}, 8.8, 2e-6,
               "the origin is taken relative to the sphere's centre");
    expect_hit(sphere, {Vec3(6, 8, 0), Vec3(-0.6f, -0.8f, 0)}, 8, 1e-6, "a or b is wrong");
}

TEST(Task1_2, ASphereIsMetFromInside) {
    const Sphere sphere = sphere_of(Vec3(0), 2);
    expect_hit(sphere, {Vec3(0), Vec3(0, 1, 0)}, 2, 1e-6,
               "from inside the smaller root is negative: the larger is the hit");
    expect_hit(sphere, {Vec3(1.2f, 0, 0), Vec3(0, 0, 1)}, 1.6, 1e-6,
               "from inside the smaller root is negative: the larger is the hit");
}

TEST(Task1_2, ASphereBehindOrBesideOrBeyondIsNoHit) {
    const Sphere sphere = sphere_of(Vec3(0), 2);
    expect_miss(sphere, {Vec3(0, 0, 5), Vec3(0, 0, 1)}, "t must be positive");
    expect_miss(sphere, {Vec3(2.01f, 0, 5), Vec3(0, 0, -1)}, "the discriminant is negative");
    expect_miss(sphere, {Vec3(0, 0, 5), Vec3(0, 0, -1), 2.9f}, "t must be less than ray.t_max");
    expect_miss(sphere, {Vec3(0), Vec3(0, 0, -1), 1.9f}, "t must be less than ray.t_max");
}

TEST(Task1_2, ASphereIsMetHoweverSmallAndNearItIs) {
    const std::string cause = "a fixed epsilon: rays are moved off their surface before they start "
                              "(spawn_ray()), so every t > 0 is a hit";
    expect_hit(sphere_of(Vec3(0), 0x1p-13f), {Vec3(0, 0, 0x1p-12f), Vec3(0, 0, -1)}, 0x1p-13, 1e-10,
               cause);
    expect_hit(sphere_of(Vec3(0), 0x1p-13f), {Vec3(0), Vec3(0, 1, 0)}, 0x1p-13, 1e-10, cause);
}

// In float, b^2 - a c is here a difference of numbers near 1e8, whose last digit is worth 8.
TEST(Task1_2, ASphereFarAwayKeepsItsShape) {
    const Sphere sphere = sphere_of(Vec3(0), 1);
    for (int i = 0; i < 9; ++i) {
        const float x = i / 10.0f;
        if (!expect_hit(sphere, {Vec3(x, 0, 10000), Vec3(0, 0, -1)}, 10000 - std::sqrt(1 - x * x),
                        2e-3, "b^2 - a c cancels: use double, or the precise form"))
            return;
    }
    expect_miss(sphere, {Vec3(1.01f, 0, 10000), Vec3(0, 0, -1)},
                "b^2 - a c cancels: use double, or the precise form");
}

Triangle triangle_of(Vec3 a, Vec3 b, Vec3 c) {
    return {{a, b, c}, normalize(cross(b - a, c - a)), -1, {0, 0, -1}};
}

TEST(Task1_2, ATriangleIsHitInsideAndNowhereElse) {
    const Triangle triangle = triangle_of(Vec3(1, 0, 0), Vec3(0, 2, 1), Vec3(-2, -1, 0.5f));
    const Vec3 weights[] = {{0.2f, 0.3f, 0.5f},   {0.9f, 0.05f, 0.05f},  {0.01f, 0.98f, 0.01f},
                            {-0.1f, 0.6f, 0.5f},  {0.7f, -0.05f, 0.35f}, {0.6f, 0.5f, -0.1f},
                            {-0.5f, -0.5f, 2.0f}, {0.34f, 0.33f, 0.33f}};
    for (const Vec3 origin : {Vec3(0.3f, 0.2f, 6), Vec3(-1, 3, -5)})
        for (const Vec3 w : weights) {
            const Vec3 p = w.x * triangle.v[0] + w.y * triangle.v[1] + w.z * triangle.v[2];
            const Ray ray = {origin, normalize(p - origin)};
            const bool inside = std::min({w.x, w.y, w.z}) > 0;
            float t = -1;
            const bool hit = hit_triangle(triangle, ShearedRay(ray), t);
            if (!expect(hit == inside,
                        fmt::format("{}, through the point with weights ({:g}, {:g}, {:g}), should "
                                    "{} the triangle; the likely cause: {}",
                                    text(ray), w.x, w.y, w.z, inside ? "hit" : "miss",
                                    inside ? "a triangle is hit from either side"
                                           : "all three edges must be passed on the same side")))
                return;
            if (inside && !expect_near("t of " + text(ray), t, length(p - origin), 1e-5,
                                       "t = n.(v0 - o) / n.d"))
                return;
            const Ray short_ray = {origin, ray.d, 0.9f * length(p - origin)};
            if (!expect(!hit_triangle(triangle, ShearedRay(short_ray), t),
                        "a triangle beyond ray.t_max should be missed but is hit; the likely "
                        "cause: t must be less than ray.t_max") ||
                !expect(!hit_triangle(triangle, ShearedRay({origin, -ray.d}), t),
                        "a triangle behind the ray should be missed but is hit; the likely cause: "
                        "t must be positive"))
                return;
        }
}

TEST(Task1_2, ASmallTriangleIsNotHitByRaysBesideIt) {
    const Triangle small =
        triangle_of(Vec3(-1e-3f, -1e-3f, 0), Vec3(1e-3f, -1e-3f, 0), Vec3(0, 1e-3f, 0));
    float t = -1;
    expect(!hit_triangle(small, ShearedRay(Ray{Vec3(0.002f, 0, 1), Vec3(0, 0, -1)}), t),
           "a ray 0.001 beside a triangle of width 0.002 should miss it but hits it; the likely "
           "cause: a fixed epsilon for the edges, in place of edge_error()");
}

TEST(Task1_2, NoRaySlipsBetweenTwoTriangles) {
    const Vec3 a(-1.1f, 0.3f, 0.2f), b(1, 1.7f, -0.3f), c(0.4f, -1, 1), d(-0.7f, 2, 0.9f);
    const Triangle left = triangle_of(a, b, c), right = triangle_of(b, a, d);
    int slipped = 0;
    for (int i = 1; i < 10000; ++i) {
        const Vec3 p = a + i / 10000.0f * (b - a); // on the shared edge, but for rounding
        const Vec3 origin(0.1f, 0.2f, 7);
        const ShearedRay ray(Ray{origin, normalize(p - origin)});
        float t;
        slipped += !hit_triangle(left, ray, t) && !hit_triangle(right, ray, t);
    }
    expect_equal("rays of 9999 that slip between two triangles at their shared edge", slipped, 0,
                 "an edge too close to call must count as passed on both sides");
}

TEST(Task1_2, TheClosestHitIsFoundWhateverTheOrder) {
    // Spheres at z = 0, 4, 2 in the file's order, then a triangle at z = 5.
    const Scene scene =
        small_scene({R"("a": {"kind": "diffuse", "reflectance": [0.5, 0.5, 0.5]})",
                     R"({"kind": "sphere", "center": [0, 0, 0], "radius": 0.5, "material": "a"},
            {"kind": "sphere", "center": [0, 0, 4], "radius": 0.5, "material": "a"},
            {"kind": "sphere", "center": [0, 0, 2], "radius": 0.5, "material": "a"},
            {"kind": "triangle", "vertices": [[5, -1, 5], [7, -1, 5], [6, 1, 5]], "material": "a"},
            {"kind": "sphere", "center": [6, 0, 3], "radius": 1, "material": "a"})"});
    const SceneView scene_view = view(scene);
    const auto expect_id = [&](const Ray& ray, int id, double t, const std::string& cause) {
        const Hit hit = closest_hit(scene_view, ray);
        if (expect_equal("shape that " + text(ray) + " meets first", hit.id, id, cause) && id >= 0)
            expect_near("its t", hit.t, t, 1e-5, "t is that of another shape");
    };
    const std::string nearest = "the nearest of all hits is wanted, not the first or the last";
    expect_id({Vec3(0, 0, 9), Vec3(0, 0, -1)}, 1, 4.5, nearest);
    expect_id({Vec3(0, 0, -9), Vec3(0, 0, 1)}, 0, 8.5, nearest);
    expect_id({Vec3(6, 0, 9), Vec3(0, 0, -1)}, 3, 4, nearest);
    expect_id({Vec3(6, 0, -9), Vec3(0, 0, 1)}, 4, 11, nearest);
    expect_id({Vec3(0, 0, 9), Vec3(0, 1, 0)}, -1, 0, "a ray that meets nothing finds nothing");
    expect_id({Vec3(0, 0, 9), Vec3(0, 0, -1), 4}, -1, 0, "what lies beyond ray.t_max is no hit");
}

TEST(Task1_2, OfTwoHitsAtTheSameDistanceTheLowestIdWins) {
    const std::string sphere =
        R"({"kind": "sphere", "center": [0, 0, 0], "radius": 1, "material": "a"})";
    const std::string face =
        R"({"kind": "triangle", "vertices": [[4, -1, 0], [6, -1, 0], [5, 1, 0]], "material": "a"})";
    const Scene scene = small_scene({R"("a": {"kind": "diffuse", "reflectance": [0.5, 0.5, 0.5]})",
                                     face + "," + sphere + "," + sphere + "," + face});
    const SceneView scene_view = view(scene);
    const std::string cause = "of two hits at the same t that of the lowest id counts";
    expect_equal("of the equal shapes 1 and 2 the one that is hit",
                 closest_hit(scene_view, {Vec3(0, 0, 5), Vec3(0, 0, -1)}).id, 1, cause);
    expect_equal("of the equal shapes 0 and 3 the one that is hit",
                 closest_hit(scene_view, {Vec3(5, 0, 5), Vec3(0, 0, -1)}).id, 0, cause);

    // The triangle touches the sphere, which is tested before it.
    const Scene touching = small_scene(
        {R"("a": {"kind": "diffuse", "reflectance": [0.5, 0.5, 0.5]})",
         R"({"kind": "triangle", "vertices": [[-1, -1, 1], [1, -1, 1], [0, 1, 1]], "material": "a"},)" +
             sphere});
    expect_equal("of a triangle 0 that touches a sphere 1 there the one that is hit",
                 closest_hit(view(touching), {Vec3(0, 0, 5), Vec3(0, 0, -1)}).id, 0, cause);
}

} // namespace

} // namespace raylab::lab01
