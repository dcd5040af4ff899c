// All labs draw the same image of thousands of spheres and quads: lab 01 tests one by one, labs 02
// and 03 glance at sixteen, lab 04 walks through a tree.
#include "app/tests/agreement.h"
#include "common/sampling/hash.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

namespace raylab::app {

namespace {

// Random numbers that are the same on every machine.
class Dice {
  public:
    explicit Dice(std::uint32_t seed) : seed_(seed) {}
    double operator()(double low, double high) {
        return low + (high - low) * to_unit(pcg4d({seed_, ++count_, 7, 7}).x);
    }
    std::string point(double low, double high) {
        const double x = (*this)(low, high), y = (*this)(low, high);
        return fmt::format("[{}, {}, {}]", x, y, (*this)(low, high));
    }

  private:
    std::uint32_t seed_, count_ = 0;
};

constexpr const char* materials[] = {"grey", "mirror", "glass", "lamp"};

std::string sphere(const std::string& center, double radius, int material) {
    return fmt::format(R"({{"kind": "sphere", "center": {}, "radius": {}, "material": "{}"}})",
                       center, radius, materials[material]);
}

// Overlapping, nested, touching and coincident spheres, tiny ones and huge ones, before, behind and
// around the camera; among turned boxes, which are quads, and a few triangles.
Scene many_shapes(int n, std::uint32_t seed, const char* integrator) {
    Dice dice(seed);
    std::string shapes =
        R"({"kind": "plane", "point": [0, -3, 0], "normal": [0, 1, 0], "material": "grey"},
           {"kind": "triangle", "vertices": [[-1, -1, 0], [1, -1, 0], [0, 1, 0]], "material": "grey"})";
    for (int i = 0; i < n; ++i) {
        const std::string at = dice.point(-2, 2);
        const int material = i % 400 == 7 ? 3 : static_cast<int>(dice(0, 2.99));
        const double radius = 0.1 * std::exp2(dice(-8, 1));
        shapes += ",\n" + sphere(at, radius, material);
        if (i % 9 == 0) shapes += ",\n" + sphere(at, 0.8 * radius, 2); // nested
        if (i % 11 == 0) shapes += ",\n" + sphere(at, radius, 0);      // coincident
        if (i % 13 == 0)                                               // a grid of touching ones
            shapes += ",\n" + sphere(fmt::format("[{}, {}, {}]", i / 13 % 8 * 0.25 - 1,
                                                 i / 104 % 8 * 0.25 - 1, i / 832 * 0.25 - 1),
                                     0.125, 0);
        if (i % 7 == 0)
            shapes += fmt::format(
                R"(,
{{"kind": "box", "low": [0, 0, 0], "high": {}, "material": "grey",
"transform": {{"rotate": [{{"axis": {}, "angle_deg": {}}}], "translate": {}}}}})",
                dice.point(0.02, 0.3), dice.point(0.1, 1), dice(0, 360), dice.point(-2, 2));
    }
    shapes += ",\n" + sphere("[0, 0, 4]", 1.5, 2); // around the camera
    shapes += ",\n" + sphere("[0, 200, 0]", 190, 0);
    return parse_scene(
        fmt::format(R"({{"version": 1, "camera": {{"position": [0, 0, 4], "look_at": [0, 0, 0],
"up": [0, 1, 0], "vfov_deg": 50}}, "film": {{"width": 20, "height": 16}},
"render": {{"integrator": "{}", "max_depth": 5, "spp": 1, "seed": {}}},
"materials": {{"grey": {{"kind": "diffuse", "reflectance": [0.6, 0.5, 0.4]}},
"mirror": {{"kind": "mirror", "reflectance": [0.9, 0.9, 0.9]}},
"glass": {{"kind": "glass", "ior": 1.5}},
"lamp": {{"kind": "diffuse", "reflectance": [0, 0, 0], "emission": [9, 9, 9]}}}},
"shapes": [{}], "lights": [{{"kind": "point", "position": [0, 5, 5], "intensity": [30, 30, 30]}}]}})",
                    integrator, seed, shapes),
        "many_shapes.json");
}

TEST(ManyShapes, AllLabsTraceTheSamePaths) {
    for (const std::uint32_t seed : {1u, 2u}) {
        const Scene scene = many_shapes(2000, seed, "path");
        ASSERT_GT(scene.quads.size(), 1500u);
        const Traced one = trace("01", scene, {}, 1), two = trace("02", scene, {}, 1),
                     three = trace("03", scene, {}, 1), four = trace("04", scene, {}, 1);
        EXPECT_EQ(first_difference(one, two, scene.camera.width), "") << seed;
        EXPECT_TRUE(same_bits(three.film, two.film)) << seed;
        EXPECT_EQ(first_difference(four, two, scene.camera.width), "") << seed;
        EXPECT_TRUE(same_bits(four.film, two.film)) << seed;
    }
}

// The tree over spheres and quads is the same whatever the triangles are in.
TEST(ManyShapes, NoStructureChangesABit) {
    for (const char* integrator : {"path", "whitted"}) {
        Scene scene = many_shapes(400, 3, integrator);
        scene.render.max_depth = 4;
        const Traced expected = trace("02", scene, {}, 1);
        for (const char* accel : {"none", "kd", "lbvh", "sah", "wide"}) {
            const Traced traced =
                trace("04", scene, {.threads = 1, .block_size = 64, .accel = {accel}}, 1);
            EXPECT_EQ(first_difference(traced, expected, scene.camera.width), "") << accel;
            EXPECT_TRUE(same_bits(traced.film, expected.film)) << accel;
        }
        scene.triangles.clear(), scene.runs.clear(); // so that no walk over triangles comes before
        EXPECT_TRUE(same_bits(trace("04", scene, {}, 1).film, trace("02", scene, {}, 1).film));
    }
}

} // namespace

} // namespace raylab::app
