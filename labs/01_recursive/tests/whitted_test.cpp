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

// Two mirrors at a right angle send a ray back where it came from, dimmed twice.
TEST(Task1_4, EachMirrorDimsWhatItShows) {
    const Scene scene = small_scene(
        {R"("half": {"kind": "mirror", "reflectance": [0.5, 0.5, 0.5]},
            "red": {"kind": "mirror", "reflectance": [1, 0.25, 0]})",
         R"({"kind": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": "half"},
            {"kind": "plane", "point": [0, 0, 0], "normal": [1, 0, 0], "material": "red"})",
         white_sky, whitted(8)});
    const Traced traced = trace_whitted(scene, {Vec3(2, 1, 0), Vec3(-0.6f, -0.8f, 0)});
    expect_vector("sky seen by two mirrors", traced.radiance, Vec3(0.5f, 0.125f, 0), 1e-6,
                  "what comes back is multiplied by the mirror's reflectance, each time");
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
