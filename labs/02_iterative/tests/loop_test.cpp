// Task 2.1: the loop and its throughput, called without any kernel.
#include "labs/02_iterative/tests/one_path.h"

namespace raylab::lab02 {

namespace {

using namespace task;

// From outside to a tilted floor through (0.3, 0.7, -0.2), whose points are off it by rounding.
Ray to_tilted_floor(int i) {
    const Vec3 n = normalize(Vec3(0.36f, 0.8f, 0.48f));
    const Vec3 aside(0.013f * i - 0.4f, 0.4f - 0.007f * i, 0.011f * i - 0.3f);
    return {Vec3(0.3f, 0.7f, -0.2f) + 3.0f * n, normalize(aside - 3.0f * n)};
}

Scene tilted_floor(const std::string& more, const std::string& light, int depth) {
    return small_scene({R"("floor": {"kind": "diffuse", "reflectance": [0.5, 0.5, 0.5]},
            "lamp": {"kind": "diffuse", "reflectance": [0, 0, 0], "emission": [3, 3, 3]})",
                        R"({"kind": "plane", "point": [0.3, 0.7, -0.2], "normal": [0.36, 0.8, 0.48],
             "material": "floor"})" +
                            more,
                        light, settings(depth, "bsdf")});
}

// Of 64 paths from the tilted floor: those of two rays, and those that say that they escaped.
struct FloorPaths {
    int of_two_rays = 0, escaped = 0;
};

FloorPaths from_tilted_floor(const Scene& scene) {
    FloorPaths paths;
    for (int i = 0; i < 64; ++i) {
        PathRecord record;
        trace(scene, to_tilted_floor(i), i, &record);
        paths.of_two_rays += record.length == 2;
        paths.escaped += record.end == PathEnd::escaped;
    }
    return paths;
}

TEST(Task2_1, PathsLeaveAFloorUpwards) {
    const FloorPaths to_lamp = from_tilted_floor(tilted_floor(
        R"(, {"kind": "quad", "material": "lamp", "vertices": [[-64.434, 3.059, 54.836],
              [44.997, -46.185, 54.836], [68.634, 6.341, -50.436], [-40.797, 55.585, -50.436]]})",
        "", 2));
    if (!expect(to_lamp.escaped < 64,
                "of 64 paths from a floor below a large lamp all escape; the likely cause: wo is "
                "-ray.d, the way back, and light is scattered on its side"))
        return;
    const FloorPaths to_sky =
        from_tilted_floor(tilted_floor("", R"({"kind": "environment", "radiance": [1, 1, 1]})", 6));
    if (expect_equal("of 64 paths from a floor to the sky those of two rays", to_sky.of_two_rays,
                     64,
                     to_sky.of_two_rays > 0 ? "the next ray meets its own surface again: "
                                              "spawn_ray() starts it off the surface"
                     : to_sky.escaped > 0   ? "where nothing is hit the path ends"
                                            : "the ray must advance: ray = spawn_ray(...)"))
        expect_equal("of 64 paths that escape those that say so", to_sky.escaped, 64,
                     "record.end is set before each way out");
}

// Where the sum of the furnace is not what it should be, but was for fewer surfaces.
std::string furnace_cause(int depth, Vec3 radiance) {
    if (depth == 1)
        return radiance.x < 1
                   ? "the first surface's emission is added times a throughput of one"
                   : "a path that runs out of depth adds nothing more: its throughput is no light";
    if (depth == 2)
        return "throughput *= weight once a surface, in each channel (the weight has the cosine "
               "already), and radiance += throughput * Le";
    return "the throughput is the product of all weights so far, and radiance += throughput * Le";
}

// In a closed sphere that glows with e and reflects a, d surfaces give e (1 - a^d) / (1 - a),
// whichever way a path takes.
TEST(Task2_1, AFurnaceIsAGeometricSeries) {
    for (const int depth : {1, 2, 3, 12}) {
        const Scene scene = small_scene(
            {R"("a": {"kind": "diffuse", "reflectance": [0.5, 0.25, 0.75], "emission": [1, 1, 1]})",
             R"({"kind": "sphere", "center": [0, 0, 0], "radius": 1, "material": "a"})", "",
             settings(depth, "bsdf")});
        PathRecord record;
        const Vec3 radiance = trace(scene, {Vec3(0.2f, 0, 0), Vec3(0, 1, 0)}, 5, &record);
        const auto series = [&](double a) { return float((1 - std::pow(a, depth)) / (1 - a)); };
        const std::string at = fmt::format(" at max_depth {}", depth);
        if (!expect_equal("rays counted in a furnace" + at, record.length, depth,
                          "the loop turns once for each of max_depth surfaces, and calls "
                          "record_hit() each time") ||
            !expect_vector("radiance in a furnace of albedo (0.5, 0.25, 0.75)" + at, radiance,
                           Vec3(series(0.5), series(0.25), series(0.75)), 1e-4,
                           furnace_cause(depth, radiance)))
            return;
    }
}

TEST(Task2_1, ThePathGoesWhereMirrorsSendIt) {
    const Scene scene = small_scene(
        {R"("half": {"kind": "mirror", "reflectance": [0.5, 0.5, 0.5]},
            "red": {"kind": "mirror", "reflectance": [1, 0.25, 0]})",
         R"({"kind": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": "half"},
            {"kind": "plane", "point": [0, 0, 0], "normal": [1, 0, 0], "material": "red"})",
         R"({"kind": "environment", "radiance": [1, 2, 3]})", settings(8, "mis")});
    expect_vector("sky", trace(scene, {Vec3(2, 1, 0), Vec3(0.6f, 0.8f, 0)}), Vec3(1, 2, 3), 1e-6,
                  "an escaped ray adds throughput * sky, and the path ends");
    PathRecord record;
    const Vec3 twice = trace(scene, {Vec3(2, 1, 0), Vec3(-0.6f, -0.8f, 0)}, 0, &record);
    expect_vector("sky of (1, 2, 3) seen by two mirrors", twice, Vec3(0.5f, 0.25f, 0), 1e-5,
                  twice.x > 0.9f ? "both mirrors dim the throughput, and an escaped ray adds "
                                   "throughput * sky"
                                 : "no light sample could have found a mirror's direction: "
                                   "bsdf_pdf is delta_pdf again");
    expect_equal("rays counted", record.length, 3, "the ray must advance: ray = spawn_ray(...)");
}

// A cosine-weighted direction from a point of a sphere leads to a point that is uniform on it, and
// the next from there is an isotropic chord, which crosses a flat lamp of area A inside with
// probability A / (2 pi) (Crofton's formula, radius 1). The first surface lies in the lamp's plane
// and sees it edge on.
TEST(Task2_1, EachBounceHasNumbersOfItsOwn) {
    const Scene scene =
        small_scene({R"("white": {"kind": "diffuse", "reflectance": [1, 1, 1]},
            "lamp": {"kind": "diffuse", "reflectance": [0, 0, 0], "emission": [1, 1, 1]})",
                     R"({"kind": "sphere", "center": [0, 0, 0], "radius": 1, "material": "white"},
            {"kind": "quad", "material": "lamp", "vertices":
             [[-0.7, 0, 0.15], [0.5, 0, 0.15], [0.5, 0, 0.65], [-0.7, 0, 0.65]]})",
                     "", settings(3, "bsdf")});
    Samples samples;
    for (int k = 0; k < 8000; ++k)
        samples.add(trace(scene, {Vec3(0.2f, 0, 0.1f), Vec3(1, 0, 0)}, k).x);
    expect_near(fmt::format("mean light of a flat lamp of area 0.6 in a white sphere, after two "
                            "bounces (standard error {:.2g})",
                            samples.error()),
                samples.mean(), 0.6 / (2 * M_PI), Samples::allowed * samples.error(),
                "each bounce has numbers of its own: sampler.get_bounce(bounce)");
}

// A floor under a point light, seen directly and in a mirror of reflectance 1/2.
TEST(Task2_1, ShadowRaysCountTimesTheThroughput) {
    const auto lit_floor = [](int depth) {
        return small_scene(
            {R"("floor": {"kind": "diffuse", "reflectance": [0.5, 0.5, 0.5]},
                "half": {"kind": "mirror", "reflectance": [0.5, 0.5, 0.5]})",
             R"({"kind": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": "floor"},
                {"kind": "plane", "point": [0, 3, 0], "normal": [0, -1, 0], "material": "half"})",
             R"({"kind": "point", "position": [0, 2, 0], "intensity": [10, 10, 10]})",
             settings(depth, "mis")});
    };
    const double floor = 0.5 / M_PI * 10 / 4;
    const Ray down = {Vec3(0, 0.5f, 0), Vec3(0, -1, 0)},
              up = {Vec3(0.001f, 2.5f, 0), Vec3(0, 1, 0)};
    expect_near("radiance of a floor under a light at max_depth 1", trace(lit_floor(1), down).x, 0,
                0, "the last surface only emits: what a shadow ray finds lies on one surface more");
    if (expect_near("radiance of a floor under a light at max_depth 2", trace(lit_floor(2), down).x,
                    floor, 1e-4,
                    "radiance += throughput * direct_light() before the surface's weight is "
                    "multiplied to the throughput"))
        expect_near("the same floor in a mirror of reflectance 0.5", trace(lit_floor(3), up).x,
                    floor / 2, 2e-4, "radiance += throughput * direct_light()");
}

// A square lamp of side 2 at height 1, seen from under its middle: radiance = albedo Le F with
//     F = 4 (A / sqrt(1 + A^2) atan(B / sqrt(1 + A^2)) + ...) / 2 pi,  A = B = 1.
// A mirror before it dims it, and counts as a surface.
TEST(Task2_1, AllStrategiesAgreeOnTheLightOfALamp) {
    const double form_factor = 4 * 2 * std::sqrt(0.5) * std::atan(std::sqrt(0.5)) / (2 * M_PI);
    for (const std::string strategy : {"bsdf", "light", "mis"}) {
        const Scene scene = small_scene(
            {R"("floor": {"kind": "diffuse", "reflectance": [0.5, 0.5, 0.5]},
                "half": {"kind": "mirror", "reflectance": [0.5, 0.5, 0.5]},
                "lamp": {"kind": "diffuse", "reflectance": [0, 0, 0], "emission": [3, 3, 3]})",
             R"({"kind": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": "floor"},
                {"kind": "plane", "point": [0, 4, 0], "normal": [0, 1, 0], "material": "half"},
                {"kind": "quad", "material": "lamp",
                 "vertices": [[-1, 1, -1], [1, 1, -1], [1, 1, 1], [-1, 1, 1]]})",
             "", settings(2, strategy)});
        Samples samples;
        for (int k = 0; k < 4000; ++k)
            samples.add(trace(scene, {Vec3(0, 0.5f, 0), Vec3(0, -1, 0)}, k).x);
        expect_near(fmt::format("mean under a lamp with direct light by \"{}\" (standard error "
                                "{:.2g})",
                                strategy, samples.error()),
                    samples.mean(), 0.5 * 3 * form_factor,
                    Samples::allowed * samples.error() + 1e-6,
                    "light counted twice or not at all: keep bsdf_pdf, the density of the ray's "
                    "direction, for the next turn's emitted_light()");
    }
}

} // namespace

} // namespace raylab::lab02
