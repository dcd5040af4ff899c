// Shapes in world space: transforms, orientation, ids, lights, and the camera.
#include "common/load/tests/scene_files.h"
#include "common/load/transform.h"
#include "common/scene/triangle_runs.h"
#include "common/trace/intersect.h"

#include <fmt/format.h>

#include <map>
#include <random>
#include <tuple>

namespace raylab {
namespace {

using Bits = std::tuple<float, float, float>;
Bits bits(Vec3 v) { return {v.x, v.y, v.z}; }

const char* const transforms[] = {
    R"({})",
    R"({"scale": [1, 2, 3], "rotate": [{"axis": [1, 2, 3], "angle_deg": 40}], "translate": [5, 6, 7]})",
    R"({"scale": [-1, 1, 1]})",
    R"({"scale": [-1.5, -2, -0.1], "rotate": [{"axis": [0, 1, 0.3], "angle_deg": -77}]})",
};

TEST(Box, IsSixOutwardQuadsThatShareTheirCornersBits) {
    for (const char* transform : transforms) {
        SCOPED_TRACE(transform);
        const Scene scene = load(scene_of_shapes(fmt::format(
            R"({{"kind": "box", "low": [-1, -1, -1], "high": [2, 1, 1], "material": "lamp", "transform": {}}})",
            transform)));
        ASSERT_EQ(scene.quads.size(), 6u);
        EXPECT_EQ(scene.lights.size(), 7u) << "six quads that glow, and the point light";
        DVec3 middle(0);
        std::map<Bits, int> corners;
        std::map<std::pair<Bits, Bits>, int> edges;
        for (const Quad& quad : scene.quads)
            for (int i = 0; i < 4; ++i) {
                middle += DVec3(quad.v[i]) / 24.0;
                ++corners[bits(quad.v[i])];
                ++edges[{bits(quad.v[i]), bits(quad.v[(i + 1) % 4])}];
            }
        EXPECT_EQ(corners.size(), 8u);
        EXPECT_EQ(edges.size(), 24u);
        for (const auto& [edge, count] :
             edges) { // closed: each edge is walked once in each direction
            EXPECT_EQ(count, 1);
            EXPECT_TRUE(edges.contains({edge.second, edge.first}));
        }
        for (const Quad& quad : scene.quads) {
            EXPECT_GT(dot(DVec3(quad.normal), DVec3(quad.v[0]) - middle), 0);
            const DVec3 n = cross(DVec3(quad.v[1] - quad.v[0]), DVec3(quad.v[3] - quad.v[0]));
            EXPECT_NEAR(dot(DVec3(quad.normal), n / std::sqrt(dot(n, n))), 1, 1e-6);
            EXPECT_NEAR(length(quad.normal), 1, 1e-6);
        }
    }
}

// The normal of a flat shape must be the inverse transpose's, not M n and not flipped by a mirror.
TEST(FlatShapes, KeepTheirSideUnderEveryTransform) {
    for (const char* transform : transforms) {
        SCOPED_TRACE(transform);
        const Scene scene = load(scene_of_shapes(fmt::format(
            R"({{"kind": "quad", "vertices": [[0,0,0], [1,0,0.5], [1,1,1.5], [0,1,1]], "material": "lamp", "transform": {0}}},
               {{"kind": "triangle", "vertices": [[0,0,0], [1,0,0.5], [0,1,1]], "material": "lamp", "transform": {0}}})",
            transform)));
        ASSERT_EQ(scene.quads.size(), 1u);
        ASSERT_EQ(scene.triangles.size(), 1u);
        // Below the plane z = x/2 + y lies a point; its image must be behind the image of the
        // plane.
        const Vec3 normal(-0.5f, -1, 1); // outward: up
        const Scene behind = load(scene_of_shapes(fmt::format(
            R"({{"kind": "sphere", "center": [{}, {}, {}], "radius": 1, "material": "lamp"}},
               {{"kind": "triangle", "vertices": [[{}, {}, {}], [100,0,0], [0,100,0]], "material": "lamp", "transform": {}}})",
            0, 0, 0, -normal.x, -normal.y, -normal.z, transform)));
        const Triangle& probe = behind.triangles.at(0);
        const Vec3 image = probe.v[0]; // of that point: a mirror swaps vertices 1 and 2
        EXPECT_LT(dot(scene.quads[0].normal, image - scene.quads[0].v[0]), 0);
        EXPECT_LT(dot(scene.triangles[0].normal, image - scene.triangles[0].v[0]), 0);
        for (const Vec3& v : scene.quads[0].v)
            EXPECT_NEAR(dot(scene.quads[0].normal, v - scene.quads[0].v[0]), 0, 1e-5);
    }
}

TEST(Transform, ScalesThenRotatesInOrderThenTranslates) {
    const Scene scene = load(scene_of_shapes(
        R"({"kind": "sphere", "center": [1, 0, 0], "radius": 0.5, "material": "white",
        "transform": {"scale": -2, "rotate": [{"axis": [0, 0, 3], "angle_deg": 90}, {"axis": [2, 0, 0], "angle_deg": 90}], "translate": [10, 0, 0]}})"));
    // (1,0,0) -> (-2,0,0) -> about z: (0,-2,0) -> about x: (0,0,-2) -> (10,0,-2)
    ASSERT_EQ(scene.spheres.size(), 1u);
    EXPECT_NEAR(scene.spheres[0].center.x, 10, 1e-6);
    EXPECT_NEAR(scene.spheres[0].center.y, 0, 1e-6);
    EXPECT_NEAR(scene.spheres[0].center.z, -2, 1e-6);
    EXPECT_FLOAT_EQ(scene.spheres[0].radius, 1);
}

TEST(Transform, NormalsStayOrthogonalToTangents) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> number(-2, 2);
    for (int i = 0; i < 100; ++i) {
        Transform t;
        for (int column = 0; column < 3; ++column)
            t.linear[column] = DVec3(number(random), number(random), number(random));
        const DVec3 a(number(random), number(random), number(random)),
            b(number(random), number(random), number(random));
        const DVec3 n = cross(a, b), image = t.normal(n);
        const double scale = std::sqrt(dot(image, image) * dot(t.linear * a, t.linear * a));
        EXPECT_NEAR(dot(image, t.linear * a) / scale, 0, 1e-9);
        EXPECT_GT(dot(image, t.linear * n), 0); // the same side
    }
}

// The camera stands at (0, 0, 5) and looks at the origin. center: as written in the file.
Scene ground(double radius, double height) {
    return load(scene_of_shapes(fmt::format(
        R"({{"kind": "sphere", "center": [0, {}, 5], "radius": {}, "material": "white"}})",
        -radius - height, radius)));
}

// How far below eye level the ground ends: by halving, with rays towards it.
double horizon(const Scene& scene) {
    double sky = 0, below = 1;
    for (int i = 0; i < 40; ++i) {
        const double dip = (sky + below) / 2;
        const Ray ray{Vec3(0, 0, 5), Vec3(std::cos(dip), -std::sin(dip), 0)};
        (intersect<feature::all>(view(scene), ray).found() ? below : sky) = dip;
    }
    return below;
}

// cos(dip) = r / (r + h).
TEST(GroundSphere, HasItsHorizonAtEveryHeight) {
    for (const double radius : {100.0, 2e4, 1e6, 7.3e6})
        for (const double height : {0.1, 1.9, 1.99, 2.0, 2.01, 2.1, 33.3}) {
            const Scene scene = ground(radius, height);
            ASSERT_EQ(scene.spheres.size(), 1u) << radius;
            EXPECT_TRUE(scene.warnings.empty());
            const double dip = std::atan(std::sqrt(height * (2 * radius + height)) / radius);
            EXPECT_NEAR(horizon(scene) / dip, 1, 1e-4) << radius << " " << height;
            // Straight down; a center or a radius in single precision would be .25 off at 7.3e6.
            const Hit hit = intersect<feature::all>(view(scene), {Vec3(0, 0, 5), Vec3(0, -1, 0)});
            EXPECT_NEAR(hit.t / height, 1, 1e-6) << radius;
        }
}

// Beyond what double holds: the plane that touches it below the camera.
TEST(GroundSphere, BecomesAPlaneWhereItsCurveCannotBeSeen) {
    const Scene flat = ground(1e12, 2);
    ASSERT_EQ(flat.planes.size(), 1u);
    EXPECT_TRUE(flat.spheres.empty());
    EXPECT_EQ(flat.warnings.size(), 1u);
    EXPECT_LT(horizon(flat), 1e-6);
    EXPECT_EQ(intersect<feature::all>(view(flat), {Vec3(0, 0, 5), Vec3(0, -1, 0)}).t, 2);

    EXPECT_EQ(ground(5e9, 1).planes.size(), 0u);
    EXPECT_EQ(ground(6e9, 1).planes.size(), 1u) << "2^30 times the distance to what it looks at";
    EXPECT_EQ(ground(6e9, 10).planes.size(), 0u) << "2^30 times the height";
    EXPECT_EQ(ground(1e12, -1).planes.size(), 0u) << "from inside its curve can be seen";
    EXPECT_EQ(ground(1, 0).planes.size(), 0u) << "a ball that the camera touches";
}

// Corners rounded at 10^4 lie up to some 10^-3 off the plane of a unit box's face.
TEST(Box, IsFlatWithinRoundingWhereverItIs) {
    for (const double away : {0.0, 1e2, 1e4, 1e5, 1e6})
        for (const char* shape : {"box", "quad"}) {
            const std::string what = shape == std::string("box")
                                         ? R"("low": [-0.5, -0.5, -0.5], "high": [0.5, 0.5, 0.5])"
                                         : R"("vertices": [[0,0,0], [1,0,0], [0.8,1,0], [0,1,0]])";
            const Scene scene = load(scene_of_shapes(fmt::format(
                R"({{"kind": "{}", {}, "material": "white", "transform": {{"rotate":
                    [{{"axis": [1, 2, 3], "angle_deg": 33}}], "translate": [{}, 0, {}]}}}})",
                shape, what, away, -away)));
            EXPECT_EQ(scene.quads.size(), shape == std::string("box") ? 6u : 1u);
        }
}

TEST(Ids, CountInFileOrderWithoutWhatIsLeftOutAndLightsFollowThem) {
    TemporaryFolder folder;
    folder.write(
        "two.obj",
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nf 1 2 3\nf 1 2 5\nf 1 3 4\n"); // the second
                                                                                     // has no area
    const Scene scene = load(scene_of_shapes(R"(
        {"kind": "triangle", "vertices": [[0,0,0], [1,0,0], [0,1,0]], "material": "lamp"},
        {"kind": "triangle", "vertices": [[0,0,0], [1,1,1], [2,2,2]], "material": "lamp"},
        {"kind": "mesh", "file": "two.obj", "material": "lamp"},
        {"kind": "sphere", "center": [0,0,0], "radius": 1, "material": "white"},
        {"kind": "box", "low": [0,0,0], "high": [1,1,1], "material": "lamp"},
        {"kind": "plane", "point": [0,0,0], "normal": [0,2,0], "material": "white"},
        {"kind": "sphere", "center": [0,9,0], "radius": 1, "material": "lamp"})"),
                             folder);
    std::map<int, int> light_of_id; // -1: none
    const auto collect = [&](const auto& shapes) {
        for (const auto& s : shapes)
            EXPECT_TRUE(light_of_id.emplace(s.tags.id, s.tags.light).second);
    };
    collect(scene.triangles);
    collect(scene.spheres);
    collect(scene.quads);
    collect(scene.planes);
    ASSERT_EQ(light_of_id.size(), 12u);
    EXPECT_EQ(light_of_id.rbegin()->first, 11);
    EXPECT_EQ(scene.warnings.size(), 2u); // one for the mesh's, one for the loose one
    int next = 0;
    for (const auto& [id, light] : light_of_id) {
        const bool dark = id == 3 || id == 10; // the white sphere, the plane
        EXPECT_EQ(light, dark ? -1 : next++) << id;
    }
    ASSERT_EQ(scene.lights.size(), std::size_t(next) + 1);
    for (const Light& light : scene.lights) {
        const int index = int(&light - scene.lights.data());
        const ShapeTags* tags = light.kind == LightKind::triangle
                                    ? &scene.triangles[light.shape].tags
                                : light.kind == LightKind::quad   ? &scene.quads[light.shape].tags
                                : light.kind == LightKind::sphere ? &scene.spheres[light.shape].tags
                                                                  : nullptr;
        if (tags != nullptr) {
            EXPECT_EQ(tags->light, index);
        }
    }
    EXPECT_EQ(scene.lights.back().kind, LightKind::point);
}

TEST(Runs, HoldTheirTrianglesAndAreFullButTheLast) {
    std::mt19937 random(2);
    std::uniform_real_distribution<float> number(-1, 1);
    for (const int count : {1, 15, 16, 17, 100, 1000}) {
        std::vector<Triangle> triangles(3);
        for (int i = 0; i < count; ++i) {
            Triangle t{{}, {}, -1, {i, 0, -1}};
            const Vec3 at(number(random), number(random), number(random));
            for (Vec3& v : t.v)
                v = at + 0.01f * Vec3(number(random), number(random), number(random));
            triangles.push_back(t);
        }
        std::vector<TriangleRun> runs;
        cut_into_runs(triangles, 3, runs);
        ASSERT_EQ(runs.size(), std::size_t((count + 15) / 16));
        int next = 3;
        std::vector<int> seen(count);
        double volume = 0;
        for (const TriangleRun& run : runs) {
            EXPECT_EQ(run.first, next);
            EXPECT_EQ(run.count, &run == &runs.back() ? count - 16 * int(runs.size() - 1) : 16);
            for (next = run.first; next < run.first + run.count; ++next) {
                ++seen[triangles[next].tags.id];
                for (const Vec3& v : triangles[next].v)
                    EXPECT_TRUE(glm::all(glm::lessThanEqual(run.bounds.low, v)) &&
                                glm::all(glm::lessThanEqual(v, run.bounds.high)));
            }
            const Vec3 size = run.bounds.high - run.bounds.low;
            volume += double(size.x) * size.y * size.z;
        }
        EXPECT_EQ(seen, std::vector<int>(count, 1));
        // In file order each of 63 runs would span nearly the whole cube of volume 8.
        if (count == 1000) {
            EXPECT_LT(volume / double(runs.size()), 0.5);
        }
    }
}

TEST(Camera, IsARightHandedFrameThatLooksAtItsPoint) {
    const Camera c =
        load(with(good_scene, "\"position\": [0, 0, 5]", "\"position\": [3, 4, 5]")).camera;
    const Vec3 expected = normalize(Vec3(-3, -4, -5));
    EXPECT_NEAR(dot(c.forward, expected), 1, 1e-6);
    EXPECT_NEAR(dot(c.right, c.forward), 0, 1e-6);
    EXPECT_NEAR(dot(cross(c.right, c.up), -c.forward), 1, 1e-6);
    EXPECT_NEAR(dot(c.right, cross(c.forward, c.up)), 1, 1e-6);
    EXPECT_GT(c.up.y, 0);
    EXPECT_FLOAT_EQ(c.half_height, float(std::tan(20 * 3.14159265358979 / 180)));
    EXPECT_FLOAT_EQ(c.half_width, 2 * c.half_height);
    EXPECT_EQ(c.lens_radius, 0);
    EXPECT_FLOAT_EQ(c.focus_distance, sqrtf(50)) << "by default what it looks at is sharp";
}

} // namespace
} // namespace raylab
