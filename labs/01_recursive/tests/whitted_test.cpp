// Task 1.4: Whitted's tracer among mirrors and glass, where every ray can be followed by hand.
#include "common/task/facts.h"
#include "common/task/small_scene.h"
#include "labs/01_recursive/tracer.h"

namespace raylab::lab01 {

namespace {

using namespace task;

struct Traced {
    Vec3 radiance;
    PathRecord record;
};

Traced trace_whitted(const Scene& scene, const Ray& ray) {
    const SceneView scene_view = view(scene);
    Traced traced{};
    const Path path = {
        scene_view, scene.render, {SamplerKind::independent, 1, 0, 0}, traced.record};
    traced.radiance = trace_whitted(path, ray, 0, 1);
    return traced;
}

const std::string white_sky = R"({"kind": "environment", "radiance": [1, 1, 1]})";

std::string whitted(int max_depth) {
    return fmt::format(R"("integrator": "whitted", "max_depth": {}, "spp": 1)", max_depth);
}

TEST(Task1_4, ARayThatMeetsNothingSeesTheSky) {
    const Scene scene =
        small_scene({R"("a": {"kind": "mirror", "reflectance": [1, 1, 1]})", "",
                     R"({"kind": "environment", "radiance": [1, 2, 3]})", whitted(4)});
    const Traced traced = trace_whitted(scene, {Vec3(0), Vec3(0, 1, 0)});
    expect_vector("sky", traced.radiance, Vec3(1, 2, 3), 1e-6, "an escaped ray returns the sky");
    expect_equal("rays counted", traced.record.length, 1, "record_hit() is called once a ray");
}

// A glowing ball where a mirror must show it.
TEST(Task1_4, AMirrorShowsWhatIsInFrontOfIt) {
    const Scene scene = small_scene(
        {R"("mirror": {"kind": "mirror", "reflectance": [1, 1, 1]},
            "lamp": {"kind": "diffuse", "reflectance": [0, 0, 0], "emission": [3, 3, 3]})",
         R"({"kind": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": "mirror"},
            {"kind": "sphere", "center": [3, 4, 0], "radius": 1, "material": "lamp"})",
         "", whitted(4)});
    const Traced traced = trace_whitted(scene, {Vec3(-3, 4, 0), Vec3(0.6f, -0.8f, 0)});
    expect(traced.radiance.x > 0,
           "radiance of a lamp in a mirror should be more than 0 but is 0; the likely cause: wo is "
           "-ray.d, the way back, and the mirror's light comes from the same side");
}

// 64 rays to a tilted mirror, whose points are off it by rounding; nothing else is there.
TEST(Task1_4, AReflectedRayLeavesItsMirror) {
    const Scene scene =
        small_scene({R"("mirror": {"kind": "mirror", "reflectance": [1, 1, 1]})",
                     R"({"kind": "plane", "point": [0.3, 0.7, -0.2], "normal": [0.36, 0.8, 0.48],
             "material": "mirror"})",
                     white_sky, whitted(6)});
    const Vec3 n = normalize(Vec3(0.36f, 0.8f, 0.48f));
    int left = 0;
    for (int i = 0; i < 64; ++i) {
        const Vec3 aside(0.013f * i - 0.4f, 0.4f - 0.007f * i, 0.011f * i - 0.3f);
        left +=
            trace_whitted(scene, {Vec3(0.3f, 0.7f, -0.2f) + 3.0f * n, normalize(aside - 3.0f * n)})
                .record.length == 2;
    }
    expect_equal("of 64 rays to a mirror under the sky those that meet it once and escape", left,
                 64,
                 "the reflected ray meets its own surface again: spawn_ray() starts it off the "
                 "surface; and record_hit() is called once a ray");
}

// Between two mirrors a ray goes up and down and leaves at the side, after ten of them.
TEST(Task1_4, TheDepthGrowsFromCallToCall) {
    const auto rays = [](int max_depth) {
        const Scene scene =
            small_scene({R"("mirror": {"kind": "mirror", "reflectance": [0.5, 0.5, 0.5]})",
                         R"({"kind": "quad", "material": "mirror",
                 "vertices": [[0, 0, -1], [8, 0, -1], [8, 0, 1], [0, 0, 1]]},
                {"kind": "quad", "material": "mirror",
                 "vertices": [[0, 1, -1], [8, 1, -1], [8, 1, 1], [0, 1, 1]]})",
                         "", whitted(max_depth)});
        return int(trace_whitted(scene, {Vec3(0.2f, 0.5f, 0), Vec3(0.6f, -0.8f, 0)}).record.length);
    };
    const int all = rays(20), three = rays(3);
    expect(three != all || all < 8,
           fmt::format("rays between two mirrors at max_depth 3 should be 3 but are {}, as many as "
                       "at max_depth 20; the likely cause: depth + 1 is not handed on",
                       three));
}

// Two mirrors at a right angle send a ray back where it came from, dimmed twice.
TEST(Task1_4, EachMirrorDimsWhatItShows) {
    const Scene facing = small_scene(
        {R"("half": {"kind": "mirror", "reflectance": [0.5, 0.25, 0.75]})",
         R"({"kind": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": "half"})",
         white_sky, whitted(8)});
    if (!expect_vector("sky in a mirror that is seen straight on",
                       trace_whitted(facing, {Vec3(0, 1, 0), Vec3(0, -1, 0)}).radiance,
                       Vec3(0.5f, 0.25f, 0.75f), 1e-6,
                       "what comes back is multiplied by the mirror's reflectance"))
        return;
    const Scene scene = small_scene(
        {R"("half": {"kind": "mirror", "reflectance": [0.5, 0.5, 0.5]},
            "red": {"kind": "mirror", "reflectance": [1, 0.25, 0]})",
         R"({"kind": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": "half"},
            {"kind": "plane", "point": [0, 0, 0], "normal": [1, 0, 0], "material": "red"})",
         white_sky, whitted(8)});
    const Traced traced = trace_whitted(scene, {Vec3(2, 1, 0), Vec3(-0.6f, -0.8f, 0)});
    expect_vector("sky seen by two mirrors", traced.radiance, Vec3(0.5f, 0.125f, 0), 1e-6,
                  "what comes back is multiplied by the mirror's weight, each time, and by nothing "
                  "else: no cosine");
    expect_equal("rays counted", traced.record.length, 3, "record_hit() is called once a ray");
}

// From the centre of a glowing mirror sphere, a ray is reflected back and forth: 1 + 1/2 + 1/4 +
// ...
TEST(Task1_4, TheRecursionEndsAtMaxDepth) {
    for (const int depth : {1, 2, 5}) {
        const Scene scene = small_scene(
            {R"("a": {"kind": "mirror", "reflectance": [0.5, 0.5, 0.5], "emission": [1, 1, 1]})",
             R"({"kind": "sphere", "center": [0, 0, 0], "radius": 1, "material": "a"})", "",
             whitted(depth)});
        const Traced traced = trace_whitted(scene, {Vec3(0), Vec3(0, 0, 1)});
        if (!expect_near(fmt::format("radiance in a glowing mirror sphere at max_depth {}", depth),
                         traced.radiance.x, 2 - std::pow(0.5, depth - 1), 1e-5,
                         "each surface adds its emission, and max_depth counts surfaces"))
            return;
    }
}

// Light that a shadow ray finds at surface 1 lies on surface 2.
TEST(Task1_4, TheLastSurfaceOnlyEmits) {
    const Scene scene = small_scene(
        {R"("floor": {"kind": "diffuse", "reflectance": [0.5, 0.5, 0.5], "emission": [1, 1, 1]})",
         R"({"kind": "quad", "material": "floor",
             "vertices": [[-9, 0, -9], [-9, 0, 9], [9, 0, 9], [9, 0, -9]]})",
         R"({"kind": "point", "position": [0, 2, 0], "intensity": [10, 10, 10]})", whitted(1)});
    expect_near("radiance of a floor that emits 1, under a light, at max_depth 1",
                trace_whitted(scene, {Vec3(0, 0.5f, 0), Vec3(0, -1, 0)}).radiance.x, 1, 1e-6,
                "the last surface only emits: what a shadow ray finds lies on one surface more");
}

TEST(Task1_4, AMirrorShowsAFloorInTheLight) {
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
                trace_whitted(scene, {Vec3(0, 0.5f, 0), Vec3(0, -1, 0)}).radiance.x, floor, 1e-4,
                "a diffuse surface adds the shadow rays to all lights");
    expect_near("the same floor in a mirror of reflectance 0.5",
                trace_whitted(scene, {Vec3(0.001f, 2.5f, 0), Vec3(0, 1, 0)}).radiance.x, floor / 2,
                2e-4, "a mirror returns its reflectance times what the reflected ray sees");
}

// The same point of a floor under a square lamp, seen directly by ray 1 of the tree and in a mirror
// by ray 2.
TEST(Task1_4, NoTwoRaysShareRandomNumbers) {
    const Scene scene = small_scene(
        {R"("floor": {"kind": "diffuse", "reflectance": [0.5, 0.5, 0.5]},
            "mirror": {"kind": "mirror", "reflectance": [1, 1, 1]},
            "lamp": {"kind": "diffuse", "reflectance": [0, 0, 0], "emission": [3, 3, 3]})",
         R"({"kind": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": "floor"},
            {"kind": "plane", "point": [-3, 0, 0], "normal": [1, 0, 0], "material": "mirror"},
            {"kind": "quad", "material": "lamp",
             "vertices": [[-1, 1, -1], [1, 1, -1], [1, 1, 1], [-1, 1, 1]]})",
         "", whitted(4)});
    const double direct =
        trace_whitted(scene, {Vec3(-2.7f, 0.4f, 0), Vec3(0.6f, -0.8f, 0)}).radiance.x;
    const double mirrored =
        trace_whitted(scene, {Vec3(-2.4f, 1.6f, 0), Vec3(-0.6f, -0.8f, 0)}).radiance.x;
    expect(std::fabs(mirrored - direct) > 1e-4 * direct || direct == 0,
           fmt::format("a point under a lamp and the same point in a mirror both have radiance "
                       "{:.6g}; the likely cause: a reflected ray has a number of its own, 2 * "
                       "node, and a refracted one 2 * node + 1, so that no two rays share random "
                       "numbers",
                       direct));
}

// Clear glass under an even sky is invisible: F of the light is reflected, 1 - F refracted.
TEST(Task1_4, GlassAsksTwiceAndLosesNothing) {
    const Scene scene =
        small_scene({R"("glass": {"kind": "glass", "ior": 1.5})",
                     R"({"kind": "sphere", "center": [0, 0, 0], "radius": 1, "material": "glass"})",
                     white_sky, whitted(14)});
    for (const float x : {0.0f, 0.5f, 0.9f}) {
        const Traced traced = trace_whitted(scene, {Vec3(x, 0, 3), Vec3(0, 0, -1)});
        if (!expect_near(fmt::format("even sky of radiance 1 through a glass sphere, {:g} from "
                                     "its middle",
                                     x),
                         traced.radiance.x, 1, 1e-3,
                         "both ways on, each times its weight; none if split.refracts is false"))
            return;
    }
}

} // namespace

} // namespace raylab::lab01
