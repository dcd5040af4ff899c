// Task 2.1: Whitted's loop over a tree of rays, called without any kernel.
#include "labs/02_iterative/tests/one_path.h"

namespace raylab::lab02 {

namespace {

using namespace task;

const std::string white_sky = R"({"kind": "environment", "radiance": [1, 1, 1]})";

// Between two mirrors a ray goes up and down and leaves at the side, after ten of them.
TEST(Task2_1, WhittedsDepthGrowsFromRayToRay) {
    const auto rays = [](int max_depth) {
        const Scene scene =
            small_scene({R"("mirror": {"kind": "mirror", "reflectance": [0.5, 0.5, 0.5]})",
                         R"({"kind": "quad", "material": "mirror",
                 "vertices": [[0, 0, -1], [8, 0, -1], [8, 0, 1], [0, 0, 1]]},
                {"kind": "quad", "material": "mirror",
                 "vertices": [[0, 1, -1], [8, 1, -1], [8, 1, 1], [0, 1, 1]]})",
                         "", whitted(max_depth)});
        PathRecord record;
        trace(scene, {Vec3(0.2f, 0.5f, 0), Vec3(0.6f, -0.8f, 0)}, 0, &record);
        return int(record.length);
    };
    const int all = rays(20), three = rays(3);
    expect(three != all || all < 8,
           fmt::format("rays between two mirrors at max_depth 3 should be 3 but are {}, as many as "
                       "at max_depth 20; the likely cause: a pending ray has depth + 1",
                       three));
}

TEST(Task2_1, WhittedsRaysAreATree) {
    const Scene mirrors = small_scene(
        {R"("a": {"kind": "mirror", "reflectance": [0.5, 0.5, 0.5], "emission": [1, 1, 1]})",
         R"({"kind": "sphere", "center": [0, 0, 0], "radius": 1, "material": "a"})", "",
         whitted(5)});
    expect_near("radiance in a glowing mirror sphere at max_depth 5",
                trace(mirrors, {Vec3(0), Vec3(0, 0, 1)}).x, 1.9375, 1e-5,
                "each surface adds throughput * emission, and max_depth counts surfaces");

    // Clear glass under an even sky is invisible; two rays leave each of its surfaces.
    const Scene glass =
        small_scene({R"("glass": {"kind": "glass", "ior": 1.5})",
                     R"({"kind": "sphere", "center": [0, 0, 0], "radius": 1, "material": "glass"})",
                     white_sky, whitted(14)});
    PathRecord record;
    const Vec3 radiance = trace(glass, {Vec3(0.5f, 0, 3), Vec3(0, 0, -1)}, 0, &record);
    expect_near("even sky of radiance 1 through a glass sphere", radiance.x, 1, 1e-3,
                "both rays go on the stack, each with throughput * its weight");
    // Inside, 13 surfaces in a row send one ray out each; the camera's ray makes one more outside.
    expect_equal("rays of the tree at max_depth 14", record.length, 27,
                 "a ray of depth + 1 == max_depth sends no others, and record_hit() counts each");
}

TEST(Task2_1, WhittedsShadowRaysReachEveryLight) {
    const Scene scene = small_scene(
        {R"("floor": {"kind": "diffuse", "reflectance": [0.5, 0.5, 0.5]},
            "half": {"kind": "mirror", "reflectance": [0.5, 0.5, 0.5]})",
         R"({"kind": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": "floor"},
            {"kind": "plane", "point": [0, 3, 0], "normal": [0, -1, 0], "material": "half"})",
         R"({"kind": "point", "position": [0, 2, 0], "intensity": [10, 10, 10]},
            {"kind": "point", "position": [0, 1, 0], "intensity": [3, 3, 3]})",
         whitted(4)});
    const double floor = 0.5 / M_PI * (10 / 4.0 + 3);
    expect_near("radiance of a floor under two lights",
                trace(scene, {Vec3(0, 0.5f, 0), Vec3(0, -1, 0)}).x, floor, 1e-4,
                "a diffuse surface adds throughput * the shadow rays to all lights");
    expect_near("the same floor in a mirror of reflectance 0.5",
                trace(scene, {Vec3(0.001f, 2.5f, 0), Vec3(0, 1, 0)}).x, floor / 2, 2e-4,
                "a diffuse surface adds throughput * the shadow rays to all lights");
}

// The same point of a floor under a square lamp, seen directly by ray 1 of the tree and in a mirror
// by ray 2.
TEST(Task2_1, NoTwoOfWhittedsRaysShareRandomNumbers) {
    const Scene scene = small_scene(
        {R"("floor": {"kind": "diffuse", "reflectance": [0.5, 0.5, 0.5]},
            "mirror": {"kind": "mirror", "reflectance": [1, 1, 1]},
            "lamp": {"kind": "diffuse", "reflectance": [0, 0, 0], "emission": [3, 3, 3]})",
         R"({"kind": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": "floor"},
            {"kind": "plane", "point": [-3, 0, 0], "normal": [1, 0, 0], "material": "mirror"},
            {"kind": "quad", "material": "lamp",
             "vertices": [[-1, 1, -1], [1, 1, -1], [1, 1, 1], [-1, 1, 1]]})",
         "", whitted(4)});
    const double direct = trace(scene, {Vec3(-2.7f, 0.4f, 0), Vec3(0.6f, -0.8f, 0)}).x;
    const double mirrored = trace(scene, {Vec3(-2.4f, 1.6f, 0), Vec3(-0.6f, -0.8f, 0)}).x;
    expect(std::fabs(mirrored - direct) > 1e-4 * direct || direct == 0,
           fmt::format("a point under a lamp and the same point in a mirror both have radiance "
                       "{:.6g}; the likely cause: a reflected ray has a number of its own, 2 * "
                       "node, and a refracted one 2 * node + 1, so that no two rays share random "
                       "numbers",
                       direct));
}

} // namespace

} // namespace raylab::lab02
